// Hidden suite of hausdorff. Expected distances are worked out by hand, or
// found by a search that needs no formula for the distance of a point and a
// triangle.
#include "exercises/09_processing/hausdorff.h"

#include <random>

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/distance_oracle.h"
#include "grader/suites/09_processing/face_lists.h"
#include "grader/suites/09_processing/smoothing_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

Fixture unnumbered(const std::string& name, IndexedMesh mesh) {
    return {name, std::move(mesh), {}};
}

double size_of(const IndexedMesh& mesh) {
    double size = 0;
    for (const Vec3 p : mesh.positions) size = std::max(size, length(p));
    return size;
}

/// Compares with the search, and the other way round as well.
void check_distance(const Fixture& a, const IndexedMesh& b) {
    const OnMesh on(a);
    const double expected = oracle::surface_distance(a.mesh, b);
    const double size = std::max(size_of(a.mesh), size_of(b));
    CHECK_THAT(hausdorff(a.mesh, b), IsAbout(expected, size));
    CHECK_THAT(hausdorff(b, a.mesh), IsAbout(expected, size));
}

/// The mesh, and a further triangle from its first edge to `tip`. From the mesh
/// to this one the distance is 0, so that what is left is that of `tip`.
IndexedMesh with_tip(IndexedMesh mesh, Vec3 tip) {
    mesh.faces.push_back(
        {mesh.faces[0][0], mesh.faces[0][1], mesh.vertex_count()});
    mesh.positions.push_back(tip);
    return mesh;
}

void check_tip(const Fixture& mesh, Vec3 tip, double expected) {
    const OnMesh on(mesh);
    INFO("a vertex at (" << tip.x << ", " << tip.y << ", " << tip.z << ")");
    const IndexedMesh longer = with_tip(mesh.mesh, tip);
    const double size = std::max(size_of(longer), 1.0);
    CHECK_THAT(hausdorff(mesh.mesh, longer), IsAbout(expected, size));
    CHECK_THAT(hausdorff(longer, mesh.mesh), IsAbout(expected, size));
}

/// Up to 1 in each direction, the same for the same seed.
class Somewhere {
public:
    explicit Somewhere(std::uint64_t salt) : random_(seed() * 100 + salt) {}
    Vec3 operator()() { return {one(), one(), one()}; }

private:
    double one() { return static_cast<double>(random_() % 20001) / 1e4 - 1; }
    std::mt19937_64 random_;
};

std::vector<Fixture> triangle_meshes() {
    return {zoo::tetra(),
            zoo::torus7(),
            zoo::fan6(),
            zoo::pillow(),
            zoo::two_triangles(),
            zoo::bow_tie_crossed(),
            zoo::hourglass(),
            zoo::moebius5(),
            zoo::rp2_6(),
            zoo::fan3(),
            hidden::bipyramid(),
            unnumbered("icosahedron", icosphere(0)),
            unnumbered("grid", grid(3, 2, Cells::triangles))};
}

IndexedMesh reversed(const IndexedMesh& mesh) {
    IndexedMesh result{mesh.positions, {}, {}};
    for (const FaceList::Face face : mesh.faces)
        result.faces.push_back({face[1], face[0], face[2]});
    return result;
}

/// Each triangle cut into three at its middle: the same surface.
IndexedMesh cut_in_three(const IndexedMesh& mesh) {
    IndexedMesh result{mesh.positions, {}, {}};
    const auto at = [&](int v) {
        return mesh.positions[static_cast<std::size_t>(v)];
    };
    for (const FaceList::Face face : mesh.faces) {
        const int middle = result.vertex_count();
        result.positions.push_back(1.0 / 3 *
                                   (at(face[0]) + at(face[1]) + at(face[2])));
        for (int k = 0; k < 3; ++k)
            result.faces.push_back({face[static_cast<std::size_t>(k)],
                                    face[static_cast<std::size_t>((k + 1) % 3)],
                                    middle});
    }
    return result;
}

}  // namespace

TEST_CASE("the nearest point is inside, on an edge, or a corner",
          "[points:3]") {
    hint("Where on the triangle is the nearest point? Draw its plane.");
    const Fixture t =
        unnumbered("triangle", {{{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}}, {}});
    const double root2 = std::sqrt(2.0);
    for (const double z : {3.0, -3.0}) {
        check_tip(t, {1, 1, z}, 3);    // inside
        check_tip(t, {0.5, 3, z}, 3);  // inside, near a corner
        check_tip(t, {2, -4, z}, 5);   // edges
        check_tip(t, {-4, 1, z}, 5);
        check_tip(t, {4, 4, z / 3}, 3);
        check_tip(t, {-4, -12, 3 * z / 3}, 13);  // corners
        check_tip(t, {16, -5, 0 * z}, 13);
        check_tip(t, {-4, 7, 4 * z}, 13);
        check_tip(t, {3, 3, z}, std::sqrt(11.0));
    }
    check_tip(t, {2, 2.5, 0}, 0.25 * root2);
    check_tip(t, {1, 1.5, 0}, 0);
    check_tip(t, {4, 0, 2}, 2);
    check_tip(t, {-1, -1, 0}, root2);
}

TEST_CASE("long and slanting triangles", "[points:2]") {
    hint("Outside two edges at once: is the corner between them the nearest?");
    const Fixture blunt = unnumbered(
        "blunt triangle", {{{-4, 1}, {4, 1}, {0, 2}}, {{0, 1, 2}}, {}});
    check_tip(blunt, {0, 7, 0}, 5);
    check_tip(blunt, {-1, 6, 0}, std::sqrt(17.0));
    check_tip(blunt, {-9, 1, 0}, 5);
    check_tip(blunt, {-8, 4, 0}, 5);
    Somewhere somewhere(50);
    for (int k = 0; k < 25; ++k) {
        Fixture thin = unnumbered("triangle", {{}, {{0, 1, 2}}, {}});
        const Vec3 p = 3 * somewhere(), along = 4 * somewhere();
        thin.mesh.positions = {p, p + along,
                               p + 0.3 * along + 0.4 * somewhere()};
        for (int probe = 0; probe < 6; ++probe)
            check_distance(
                thin, with_tip(thin.mesh, p + 0.5 * along + 3 * somewhere()));
    }
}

TEST_CASE("meshes and rough copies of them", "[points:3]") {
    hint("Which is the smallest value, and which the largest of them?");
    std::uint64_t salt = 60;
    for (const Fixture& mesh : triangle_meshes()) {
        check_distance(mesh, hidden::roughened(mesh.mesh, salt));
        check_distance(
            unnumbered("shuffled", hidden::shuffled(mesh.mesh, salt)),
            hidden::roughened(mesh.mesh, salt + 100));
        ++salt;
    }
}

TEST_CASE("meshes of different shape and resolution", "[points:2]") {
    hint("Are you sure that the nearest point belongs to the nearest vertex?");
    const std::vector<Fixture> meshes = triangle_meshes();
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        check_distance(meshes[k], meshes[(k + 1) % meshes.size()].mesh);
        check_distance(meshes[k], meshes[(k + 4) % meshes.size()].mesh);
    }
    const Fixture ball = unnumbered("icosphere", icosphere(1));
    check_distance(ball, icosphere(0));
    IndexedMesh table = grid(1, 1, Cells::triangles);
    for (Vec3& p : table.positions) p = 8 * p - Vec3{4, 4, 1.5};
    check_distance(ball, table);
}

TEST_CASE("the way there and the way back", "[points:2]") {
    hint("Is a near b everywhere when b is everywhere near a?");
    for (const Fixture& mesh : {zoo::fan6(), zoo::tetra(), zoo::hourglass()}) {
        const IndexedMesh spike = with_tip(mesh.mesh, {3, 20, 4});
        const OnMesh on(mesh);
        const double far = oracle::one_way_distance(spike, mesh.mesh);
        CHECK_THAT(hausdorff(mesh.mesh, spike), IsAbout(far));
        CHECK_THAT(hausdorff(spike, mesh.mesh), IsAbout(far));
    }
    const Fixture plane = unnumbered("grid", grid(4, 3, Cells::triangles));
    IndexedMesh half{plane.mesh.positions, {}, {}};
    for (int f = 0; f < plane.mesh.faces.size() / 3; ++f)
        half.faces.push_back(plane.mesh.faces[f]);
    const OnMesh on(plane);
    CHECK_THAT(hausdorff(plane.mesh, half), IsAbout(2));
    CHECK_THAT(hausdorff(half, plane.mesh), IsAbout(2));
}

TEST_CASE("vertices that no face uses, and loose edges", "[points:2]") {
    hint("Which vertices lie on the surface at all?");
    for (const Fixture& plain : {zoo::tetra(), zoo::fan6(), zoo::pillow()}) {
        Fixture mesh = plain;
        mesh.mesh.positions.push_back({90, 0, 0});
        mesh.mesh.positions.insert(mesh.mesh.positions.begin(), {0, -70, 0});
        mesh.mesh.faces = {};
        for (const FaceList::Face face : plain.mesh.faces)
            mesh.mesh.faces.push_back({face[0] + 1, face[1] + 1, face[2] + 1});
        mesh.mesh.loose_edges = {{0, 1}};
        const OnMesh on(mesh);
        CHECK_THAT(hausdorff(mesh.mesh, plain.mesh), IsAbout(0, 4));
        CHECK_THAT(hausdorff(plain.mesh, mesh.mesh), IsAbout(0, 4));
        check_distance(mesh, hidden::roughened(plain.mesh, 90));
    }
}

TEST_CASE("triangles without an area", "[points:2]") {
    hint("What do you divide by, when all corners lie on one line?");
    const IndexedMesh segment{
        {{0, 0, 0}, {6, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}, {}};
    const IndexedMesh between{
        {{2, 0, 0}, {6, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}, {}};
    const IndexedMesh point{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}, {}};
    const IndexedMesh two_equal{{{0, 0, 0}, {6, 0, 0}}, {{0, 1, 1}}, {}};
    const IndexedMesh one_vertex{{{1, 2, 3}}, {{0, 0, 0}}, {}};
    const Fixture t = unnumbered(
        "triangle", {{{0, 3, 0}, {5, 3, 4}, {6, 8, 0}}, {{0, 1, 2}}, {}});
    for (const IndexedMesh& thin :
         {segment, between, point, two_equal, one_vertex}) {
        check_distance(t, thin);
        check_distance(unnumbered("tetra", zoo::tetra().mesh), thin);
        check_distance(unnumbered("without area", thin), segment);
        check_distance(unnumbered("without area", thin), point);
    }
    const OnMesh on(t);
    CHECK_THAT(hausdorff(t.mesh, segment), IsAbout(8));
    CHECK_THAT(hausdorff(point, one_vertex), IsAbout(0, 4));
    CHECK_THAT(hausdorff(two_equal, segment), IsAbout(0, 6));
    IndexedMesh joined = t.mesh;  // a sound triangle and one without area
    joined.positions.push_back({0, -9, 0});
    joined.faces.push_back({0, 3, 3});
    CHECK_THAT(hausdorff(joined, t.mesh), IsAbout(12));
    check_distance(unnumbered("with a thorn", joined), t.mesh);
}

TEST_CASE("one surface written in two ways", "[points:1]") {
    hint("Does the sense of a triangle, or its number, change the surface?");
    for (const Fixture& mesh : triangle_meshes()) {
        const OnMesh on(mesh);
        const double size = size_of(mesh.mesh);
        CHECK_THAT(hausdorff(mesh.mesh, mesh.mesh), IsAbout(0, size));
        CHECK_THAT(hausdorff(mesh.mesh, reversed(mesh.mesh)), IsAbout(0, size));
        CHECK_THAT(hausdorff(cut_in_three(mesh.mesh), mesh.mesh),
                   IsAbout(0, size));
        CHECK_THAT(hausdorff(mesh.mesh, hidden::shuffled(mesh.mesh, 91)),
                   IsAbout(0, size));
    }
}

TEST_CASE("far from the origin, turned, large and small", "[points:1]") {
    hint("Do you compare with a number that does not grow with the mesh?");
    for (const double scale : {1e-6, 1e-3, 1.0, 1e4, 1e8})
        for (const Fixture& plain : {zoo::tetra(), zoo::fan6(), zoo::rp2_6()}) {
            Fixture mesh = plain;
            IndexedMesh rough = hidden::roughened(plain.mesh, 92);
            for (IndexedMesh* each : {&mesh.mesh, &rough})
                for (Vec3& p : each->positions)
                    p = scale * Vec3{0.6 * p.x - 0.8 * p.z + 5, p.y - 9,
                                     0.8 * p.x + 0.6 * p.z};
            check_distance(mesh, rough);
        }
}

TEST_CASE("a mesh without a face is refused", "[points:1]") {
    hint("Has a mesh of vertices alone a surface?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    const IndexedMesh points{tetra.mesh.positions, {}, {{0, 1}}};
    for (const IndexedMesh& none : {IndexedMesh{}, points}) {
        CHECK_THROWS_AS(hausdorff(none, tetra.mesh), std::invalid_argument);
        CHECK_THROWS_AS(hausdorff(tetra.mesh, none), std::invalid_argument);
        CHECK_THROWS_AS(hausdorff(none, points), std::invalid_argument);
    }
}
