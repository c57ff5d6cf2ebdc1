// Hidden suite of vertex_normals: gathered for each vertex by a search through
// the face list, with shadows for areas.
#include "exercises/06_geometry/vertex_normals.h"

#include <algorithm>
#include <random>
#include <vector>

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

std::size_t at(int v) {
    return static_cast<std::size_t>(v);
}

Vec3 gathered(const IndexedMesh& mesh, int v) {
    Vec3 sum;
    double size = 0;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const auto face = mesh.faces[f];
        const auto times = std::count(face.begin(), face.end(), v);
        if (times == 0) continue;
        const std::vector<Vec3> corners = normals::corners_of(mesh, f);
        sum =
            sum + static_cast<double>(times) * normals::twice_shadows(corners);
        size += static_cast<double>(times) * normals::squared_sides(corners);
    }
    return length(sum) <= 1e-12 * size ? Vec3{} : sum;
}

std::vector<Vec3> expected_of(const IndexedMesh& mesh) {
    std::vector<Vec3> expected;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        expected.push_back(gathered(mesh, v));
    return expected;
}

void check_mesh(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK_THAT(vertex_normals(fixture.mesh),
               AreDirections(expected_of(fixture.mesh)));
}

void check_at_random_points(const Fixture& fixture, std::uint64_t salt) {
    check_mesh(normals::at_random_points(fixture, salt));
}

/// Those of the zoo that have no half-edge table.
std::vector<Fixture> without_table() {
    return {zoo::fan3(),     zoo::house_with_wall(), zoo::moebius3q(),
            zoo::moebius5(), zoo::klein4x4(),        zoo::rp2_6()};
}

/// Faces of three to nine corners, at random: nothing fits together.
Fixture faces_at_random(std::uint64_t salt) {
    std::mt19937_64 random(seed() * 1000 + salt);
    IndexedMesh mesh;
    mesh.positions = normals::random_points(40, salt);
    for (int f = 0; f < 30; ++f) {
        std::vector<int> face;
        for (std::uint64_t n = 3 + random() % 7; n > 0; --n) {
            int v = static_cast<int>(random() % 36);
            while (std::count(face.begin(), face.end(), v) > 0) ++v;
            face.push_back(v % 40);
        }
        mesh.faces.push_back(face);
    }
    return {"faces at random", mesh, {}};
}

Vec3 bulge(Vec3 p) {
    return {p.x, p.y, p.x * p.y / 64};
}

}  // namespace

TEST_CASE("boxes, corner by corner", "[points:1]") {
    hint("Each face adds its area vector as it is, at each of its corners.");
    for (const Vec3 size : {Vec3{1, 1, 1}, Vec3{1, 2, 3}, Vec3{5, 0.5, 2}}) {
        Fixture box = zoo::cube();
        std::vector<Vec3> expected;
        for (Vec3& p : box.mesh.positions) {
            const Vec3 outwards{2 * p.x - 1, 2 * p.y - 1, 2 * p.z - 1};
            expected.push_back({outwards.x * size.y * size.z,
                                outwards.y * size.z * size.x,
                                outwards.z * size.x * size.y});
            p = {p.x * size.x, p.y * size.y, p.z * size.z};
        }
        const OnMesh on(box);
        CHECK_THAT(vertex_normals(box.mesh), AreDirections(expected));
        check_mesh(normals::box(size));
    }
}

TEST_CASE("meshes of triangles", "[points:1]") {
    hint("Do all three corners of a face get its area vector?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : normals::triangle_meshes())
        check_at_random_points(fixture, ++salt);
    check_mesh({"icosphere", icosphere(2), {}});
    check_mesh({"torus", torus(12, 7, Cells::triangles), {}});
}

TEST_CASE("meshes of polygons", "[points:1]") {
    hint(
        "Which triangles make up the area vector of a face with many sides? "
        "Do all its corners get it?");
    std::uint64_t salt = 100;
    for (const Fixture& fixture : hidden::made_by_hand())
        check_at_random_points(fixture, ++salt);
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_at_random_points(fixture, ++salt);
    for (const Fixture& fixture : generated_fixtures())
        check_at_random_points(fixture, ++salt);
}

TEST_CASE("faces that are not convex", "[points:1]") {
    hint("At a reflex corner a triangle points backwards. Is it added so?");
    // Two L-shapes that bend away from each other along their common side.
    const Fixture fixture{"two L-shapes",
                          {{{0, 0, 0},
                            {2, 0, 0},
                            {2, 1, 0},
                            {1, 1, 0},
                            {1, 2, 0},
                            {0, 2, 0},
                            {2, 0, 2},
                            {1, 0, 2},
                            {1, 0, 1},
                            {0, 0, 1}},
                           {{0, 1, 2, 3, 4, 5}, {1, 0, 9, 8, 7, 6}},
                           {}},
                          {}};
    const OnMesh on(fixture);
    const Vec3 up{0, 0, 1}, front{0, 1, 0};
    CHECK_THAT(vertex_normals(fixture.mesh),
               AreDirections({up + front, up + front, up, up, up, up, front,
                              front, front, front}));
    for (const Fixture& copy : normals::in_all_motions(fixture))
        check_mesh(copy);
}

TEST_CASE("lists of faces that no table could hold", "[points:1]") {
    hint(
        "Do you rely on more than the list: that an edge has two faces, or "
        "that they are well oriented?");
    std::uint64_t salt = 300;
    for (const Fixture& fixture : without_table()) {
        check_mesh(fixture);
        check_at_random_points(fixture, ++salt);
    }
    for (int k = 0; k < 20; ++k) check_mesh(faces_at_random(++salt));
}

TEST_CASE("vertices that no face uses", "[points:1]") {
    hint("How many vectors are there in the result, and in which order?");
    check_mesh({"empty mesh", {}, {}});
    check_mesh({"points only", {normals::random_points(5, 401), {}, {}}, {}});
    for (const Fixture& fixture : {zoo::slide(), zoo::torus7()}) {
        Fixture sparse = normals::at_random_points(fixture, 402);
        std::vector<Vec3>& p = sparse.mesh.positions;
        for (const Vec3 more : normals::random_points(4, 403))
            p.push_back(more);
        check_mesh(sparse);
        // The same with all vertices numbered from the other end.
        std::reverse(p.begin(), p.end());
        FaceList faces;
        for (const auto face : sparse.mesh.faces) {
            std::vector<int> turned;
            for (const int v : face)
                turned.push_back(sparse.mesh.vertex_count() - 1 - v);
            faces.push_back(turned);
        }
        sparse.mesh.faces = faces;
        sparse.mesh.loose_edges = {{0, 1}, {2, 9}};
        check_mesh(sparse);
    }
}

TEST_CASE("sums that mean nothing", "[points:1]") {
    hint(
        "How long is the sum where normals cancel out, and what do you "
        "compare it with?");
    for (const Fixture& fixture : {zoo::pillow(), normals::flat_tetra()})
        for (const Fixture& copy : normals::in_all_motions(fixture))
            check_mesh(copy);
    check_at_random_points(zoo::pillow(), 501);
    const Vec3 along{0.3, 0.7, 1.1};
    const Fixture on_a_line{
        "faces on a line",
        {{{}, 0.3 * along, 1.7 * along, 0.9 * along, {1, 0, 0}},
         {{0, 1, 2}, {3, 2, 1, 0}, {0, 3, 4}},
         {}},
        {}};
    for (const Fixture& copy : normals::in_all_motions(on_a_line))
        check_mesh(copy);
    // Twice the area is 2 w, the squares of the sides are 2 in all.
    for (const double w : {2e-12, 1.4e-12, 0.7e-12, 1e-14}) {
        const Fixture strip{
            "strip", {{{}, {1, 0}, {1, w}, {0, w}}, {{0, 1, 2, 3}}, {}}, {}};
        check_mesh(strip);
    }
    // The second face has sides but no area: at 0 and 1 it makes the
    // difference.
    check_mesh({"strip and fold",
                {{{}, {1, 0}, {1, 1.5e-12}, {0, 1.5e-12}, {1, 0}, {}},
                 {{0, 1, 2, 3}, {1, 0, 5, 4}},
                 {}},
                {}});
    Fixture squashed = normals::at_random_points(zoo::tetra(), 502);
    for (Vec3& p : squashed.mesh.positions) p.z *= 1e-5;
    check_mesh(squashed);
    Fixture point = zoo::cube();
    for (Vec3& p : point.mesh.positions) p = along;
    check_mesh(point);
}

TEST_CASE("turned, moved, small and large", "[points:1]") {
    hint("Do the unit of length or the place of the mesh change a normal?");
    for (const Fixture& fixture :
         {normals::at_random_points(zoo::torus7(), 601),
          normals::at_random_points(zoo::slide(), 602),
          normals::at_random_points(zoo::house(), 603)}) {
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

TEST_CASE("a mesh of 12800 triangles", "[points:1]") {
    hint("How often do you go through the list of faces?");
    IndexedMesh mesh = grid(80, 80, Cells::triangles);
    for (Vec3& p : mesh.positions) p = bulge(p);
    std::vector<Vec3> expected(mesh.positions.size());
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const Vec3 area = normals::twice_shadows(normals::corners_of(mesh, f));
        for (const int v : mesh.faces[f])
            expected[at(v)] = expected[at(v)] + area;
    }
    const Fixture fixture{"grid of 12800 triangles", std::move(mesh), {}};
    const OnMesh on(fixture);
    CHECK_THAT(vertex_normals(fixture.mesh), AreDirections(expected));
}
