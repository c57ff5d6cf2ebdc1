// Hidden suite of vertex_normal: boxes whose sides are counted, and the faces
// that the face list has at a vertex, with other formulas for area and angle.
#include "exercises/06_geometry/vertex_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/by_faces.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

constexpr std::array weights = {Weight::uniform, Weight::area, Weight::angle};

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// A corner of a triangle, and the corners after it.
struct Corner {
    Vec3 v, p, q;
};

Corner corner_at(const IndexedMesh& mesh, int f, int v) {
    const auto face = mesh.faces[f];
    for (std::size_t k = 0; k < 3; ++k)
        if (face[k] == v)
            return {mesh.positions[at(v)],
                    mesh.positions[at(face[(k + 1) % 3])],
                    mesh.positions[at(face[(k + 2) % 3])]};
    throw std::logic_error("the face has no such corner");
}

/// The sum over these faces, each a triangle with a corner at v. A degenerate
/// one has an area of nothing but rounding.
Vec3 mean_of(const IndexedMesh& mesh, const std::vector<int>& faces, int v,
             Weight weight) {
    Vec3 sum;
    double all = 0;
    for (const int f : faces) {
        const Corner c = corner_at(mesh, f, v);
        const std::array corners = {c.v, c.p, c.q};
        const Vec3 area = normals::twice_shadows(corners);
        if (length(area) <= 1e-12 * normals::squared_sides(corners)) continue;
        const double w = weight == Weight::uniform ? 1
                         : weight == Weight::area
                             ? length(area) / 2
                             : normals::angle_at(c.v, c.p, c.q);
        sum = sum + (w / length(area)) * area;
        all += w;
    }
    return length(sum) <= 1e-12 * all ? Vec3{} : sum;
}

/// At most `most` of the half-edges, or a few more: each call costs its time.
std::vector<int> some_half_edges(const HalfEdgeTable& he, int most) {
    const int step = std::max(1, he.size() / most);
    std::vector<int> some;
    for (int i = 0; i < he.size(); i += step) some.push_back(i);
    return some;
}

class Checked {
public:
    explicit Checked(const Fixture& fixture)
        : fixture_(fixture), on_(fixture), faces_(fixture) {}

    void check(int i, Weight weight) const {
        std::vector<int> met = faces_.faces_met(i);
        std::erase(met, -1);
        const Vec3 mean = mean_of(fixture_.mesh, met, faces_.start(i), weight);
        CHECK_THAT(
            vertex_normal(fixture_.he, fixture_.mesh.positions, i, weight),
            IsDirection(mean));
    }

private:
    const Fixture& fixture_;
    OnMesh on_;
    oracle::ByFaces faces_;
};

/// Half-edge after half-edge, with the weights in turn.
void check_mesh(const Fixture& fixture) {
    const Checked mesh(fixture);
    std::size_t turn = 0;
    for (const int i : some_half_edges(fixture.he, 24))
        mesh.check(i, weights[turn++ % weights.size()]);
}

/// Every half-edge, each with all weights: for small meshes.
void check_all_of(const Fixture& fixture) {
    const Checked mesh(fixture);
    for (int i = 0; i < fixture.he.size(); ++i)
        for (const Weight weight : weights) mesh.check(i, weight);
}

/// How many triangles of each side of a box meet at vertex v, as a vector: the
/// sides at v look in the directions in which v lies from the middle.
Vec3 triangles_of_sides(const Fixture& box, int v) {
    Vec3 count;
    for (int f = 0; f < box.mesh.faces.size(); ++f)
        for (const int corner : box.mesh.faces[f]) {
            if (corner != v) continue;
            const Vec3 n =
                normals::twice_shadows(normals::corners_of(box.mesh, f));
            count = count + (1 / length(n)) * n;
        }
    return count;
}

/// Every corner of a box, as its counted triangles say.
template <class Expected>
void check_boxes(Weight weight, Expected expected) {
    for (const Vec3 size : {Vec3{1, 1, 1}, Vec3{1, 2, 3}, Vec3{5, 0.5, 2}}) {
        const Fixture made = normals::box(size);
        for (const Fixture& box : {made, renumbered(made, 1)}) {
            const OnMesh on(box);
            const oracle::ByFaces faces(box);
            for (int i = 0; i < box.he.size(); ++i)
                CHECK_THAT(vertex_normal(box.he, box.mesh.positions, i, weight),
                           IsDirection(expected(
                               size, triangles_of_sides(box, faces.start(i)))));
        }
    }
}

Vec3 sign_of(Vec3 v) {
    const auto sign = [](double x) { return x > 0 ? 1.0 : -1.0; };
    return {sign(v.x), sign(v.y), sign(v.z)};
}

Fixture triangles(std::string name, const IndexedMesh& mesh) {
    return {std::move(name), mesh, build(mesh)};
}

std::vector<Fixture> random_triangle_meshes() {
    std::vector<Fixture> all;
    for (std::uint64_t k = 0; k < 6; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.merge_percent = 0;
        options.parts = 1 + static_cast<int>(k % 2);
        options.hole_percent = 10;
        options.surface = k < 3 ? Surface::open : Surface::mixed;
        const IndexedMesh mesh = random_polygons(seed() * 100 + k, options);
        all.push_back(
            normals::cut_to_triangles({"random triangles", mesh, build(mesh)}));
    }
    return all;
}

/// Six triangles round vertex 0 in the plane of u and w, and between each two
/// of them a needle.
Fixture flat_needles(Vec3 middle, Vec3 u, Vec3 w) {
    IndexedMesh mesh{{middle}, {}, {}};
    for (int k = 0; k < 12; ++k) {
        const double turn = 1.047 * (k / 2) + 1e-10 * (k % 2);
        mesh.positions.push_back(middle + std::cos(turn) * u +
                                 std::sin(turn) * w);
        mesh.faces.push_back({0, 1 + k, 1 + (k + 1) % 12});
    }
    return triangles("flat needles", mesh);
}

/// Two triangles back to back, but for `gap`: their unit normals are (0, 0, 1)
/// and (gap, 0, -1), up to the square of the gap, and all else is the same.
Fixture almost_closed_book(double gap) {
    return triangles("book", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, gap}},
                              {{0, 1, 2}, {0, 2, 3}},
                              {}});
}

}  // namespace

TEST_CASE("corners of boxes: uniform", "[points:1]") {
    hint(
        "Each triangle counts as much as any other. Is it the unit normal "
        "that you add?");
    check_boxes(Weight::uniform, [](Vec3, Vec3 count) { return count; });
}

TEST_CASE("corners of boxes: by area", "[points:1]") {
    hint("Each triangle counts by its area. Once, not squared?");
    check_boxes(Weight::area, [](Vec3 size, Vec3 count) {
        return Vec3{count.x * size.y * size.z, count.y * size.z * size.x,
                    count.z * size.x * size.y};
    });
}

TEST_CASE("corners of boxes: by angle", "[points:1]") {
    hint(
        "However a side is cut into triangles: its angles at the corner make "
        "a right angle. Which angle of the triangle do you take?");
    check_boxes(Weight::angle, [](Vec3, Vec3 count) { return sign_of(count); });
}

TEST_CASE("closed meshes", "[points:1]") {
    hint("Which faces does the walk round the vertex meet, and how often?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::torus7(), zoo::hourglass(), hidden::bipyramid(),
          normals::cut_to_triangles(zoo::house()),
          normals::cut_to_triangles(hidden::two_tori()),
          triangles("icosphere", icosphere(1)),
          triangles("torus", torus(8, 5, Cells::triangles))}) {
        check_mesh(fixture);
        check_mesh(renumbered(fixture, 2));
    }
}

TEST_CASE("open meshes, loose edges and bow-ties", "[points:1]") {
    hint(
        "What do the half-edges without a face add? And what is met on the "
        "other side of the gap?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : normals::triangle_meshes()) {
        ++salt;
        check_mesh(normals::at_random_points(renumbered(fixture, salt), salt));
    }
}

TEST_CASE("random meshes", "[points:1]") {
    hint("Try it by hand at a vertex with three different triangles.");
    std::uint64_t salt = 100;
    for (const Fixture& fixture : random_triangle_meshes()) {
        ++salt;
        check_mesh(normals::at_random_points(renumbered(fixture, salt), salt));
    }
}

TEST_CASE("turned, moved, small and large", "[points:1]") {
    hint("Do the unit of length or the place of the mesh change a normal?");
    for (const Fixture& fixture :
         {normals::at_random_points(zoo::torus7(), 51),
          normals::at_random_points(zoo::bow_tie_crossed(), 52)}) {
        for (const Fixture& copy : normals::in_all_motions(fixture))
            check_mesh(copy);
        check_mesh(normals::moved(fixture, normals::far_away()));
        for (const double s : {1e-20, 1e-9, 1e9}) {
            Fixture scaled = fixture;
            for (Vec3& p : scaled.mesh.positions) p = s * p;
            check_mesh(scaled);
        }
    }
}

TEST_CASE("degenerate triangles count for nothing", "[points:1]") {
    hint(
        "What does face_normal say about a triangle on a line? Where does "
        "NaN come from?");
    for (const Fixture& sound :
         {zoo::fan6(), zoo::torus7(), zoo::tetra(), hidden::bipyramid()}) {
        const auto face = sound.mesh.faces[0];
        // Two corners of one face at one place: its neighbour is degenerate,
        // too. Then three on a line.
        Fixture fixture = normals::at_random_points(sound, 61);
        std::vector<Vec3>& p = fixture.mesh.positions;
        p[at(face[1])] = p[at(face[0])];
        check_mesh(fixture);
        p = normals::random_points(fixture.mesh.vertex_count(), 62);
        p[at(face[2])] =
            p[at(face[0])] + 0.3 * (p[at(face[1])] - p[at(face[0])]);
        check_mesh(fixture);
    }
    Fixture nothing = zoo::tetra();
    for (Vec3& p : nothing.mesh.positions) p = {0.1, 0.2, 0.3};
    check_mesh(nothing);
}

TEST_CASE("angles of needles", "[points:1]") {
    hint("What can rounding do to a cosine that is almost 1?");
    const std::vector<Vec3> points = normals::random_points(120, 81);
    for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
        const Vec3 u = points[k + 1], w = points[k + 2], up = cross(u, w);
        if (length(up) < 0.1) continue;
        const Fixture fixture = flat_needles(points[k], u, w);
        const OnMesh on(fixture);
        const int i = hidden::half_edge(fixture, 0, 1);
        CHECK_THAT(
            vertex_normal(fixture.he, fixture.mesh.positions, i, Weight::angle),
            IsDirection(up));
    }
}

TEST_CASE("vertices without a normal", "[points:1]") {
    hint(
        "How long is the sum where normals cancel out? What do you compare it "
        "with?");
    for (const Fixture& fixture :
         {zoo::pillow(), hidden::loose_chain(), hidden::loose_edge_before(),
          hidden::loose_edge_after(), zoo::dangling()}) {
        check_all_of(
            normals::at_random_points(normals::cut_to_triangles(fixture), 71));
    }
    for (const Fixture& fixture :
         normals::in_all_motions(normals::flat_tetra()))
        check_all_of(fixture);
}

TEST_CASE("normals that almost cancel out", "[points:1]") {
    hint(
        "With what is the length of the sum compared: with the sum of all "
        "weights?");
    Fixture squashed = normals::flat_tetra();
    squashed.mesh.positions[3] = squashed.mesh.positions[3] + Vec3{0, 0, 1e-5};
    check_all_of(squashed);
    for (const double gap : {1e-13, 1.4e-12, 3e-12, 1e-11}) {
        const Fixture book = almost_closed_book(gap);
        const OnMesh on(book);
        const int i = hidden::half_edge(book, 0, 1);
        for (const Weight weight : weights)
            CHECK_THAT(vertex_normal(book.he, book.mesh.positions, i, weight),
                       IsDirection({gap > 2e-12 ? 1.0 : 0.0, 0, 0}));
    }
}

TEST_CASE("no more reads than the edges of the vertex need", "[points:1]") {
    hint("Do you look at half-edges that are far from the vertex?");
    const Fixture fixture = renumbered(
        triangles("grid of triangles", grid(25, 25, Cells::triangles)), 3);
    const OnMesh on(fixture);
    const HalfEdgeTable& he = fixture.he;
    for (const int i : some_half_edges(he, 40))
        for (const Weight weight : weights) {
            const ReadBudget budget(he, 40 * 6 + 40);
            CHECK_THAT(vertex_normal(he, fixture.mesh.positions, i, weight),
                       IsDirection({0, 0, 1}));
        }
}
