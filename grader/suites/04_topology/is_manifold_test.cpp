// Hidden suite of is_manifold. A guess is right half the time: each case asks
// for both answers, many times.
#include "exercises/04_topology/is_manifold.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_manifold(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(is_manifold(fixture.mesh) == oracle::is_surface(fixture.mesh));
}

/// As it is, and three times shuffled.
void check_shuffled(const Fixture& fixture) {
    check_manifold(fixture);
    for (const std::uint64_t salt : {1U, 2U, 3U})
        check_manifold(hidden::shuffled(fixture, salt));
}

/// A mesh of which only the connectivity is asked for.
Fixture faces_only(const std::string& name, const FaceList& faces) {
    IndexedMesh mesh{{}, faces, {}};
    for (const int v : faces.corners())
        while (mesh.vertex_count() <= v) {
            const double t = mesh.vertex_count();
            mesh.positions.push_back({std::cos(t), std::sin(2 * t), 0.1 * t});
        }
    return hidden::face_list_only(name, mesh);
}

/// `n` triangles round vertex 0, closed, and another fan of three there.
FaceList hub(int n, int other_fan) {
    FaceList faces;
    for (int k = 0; k < n; ++k) faces.push_back({0, 1 + k, 1 + (k + 1) % n});
    for (int k = 0; k < other_fan; ++k)
        faces.push_back({0, n + 1 + k, n + 2 + k});
    return faces;
}

/// Pairs of different vertices of the mesh that some faces use.
std::vector<std::array<int, 2>> pairs(const IndexedMesh& mesh, int n,
                                      std::uint64_t salt) {
    const std::vector<int> any =
        hidden::any_order(std::ssize(mesh.faces.corners()) > 0
                              ? static_cast<int>(mesh.faces.corners().size())
                              : 0,
                          salt);
    std::vector<std::array<int, 2>> found;
    for (std::size_t k = 0; k + 1 < any.size() && std::ssize(found) < n; ++k) {
        const auto corner = [&](std::size_t i) {
            return mesh.faces.corners()[static_cast<std::size_t>(any[i])];
        };
        if (corner(k) != corner(k + 1))
            found.push_back({corner(k), corner(k + 1)});
    }
    return found;
}

}  // namespace

TEST_CASE("the meshes of the lecture and their like", "[points:2]") {
    hint("Edge by edge, vertex by vertex: what must hold at each?");
    for (const Fixture& fixture : hidden::all_face_lists())
        check_shuffled(fixture);
}

TEST_CASE("edges with more than two faces", "[points:2]") {
    hint("Do you find an edge again when a face names it the other way?");
    const FaceList book = zoo::fan3().mesh.faces;
    for (int turned = 0; turned < 8; ++turned) {
        std::vector<int> faces;
        for (int f = 0; f < 3; ++f)
            if ((turned >> f) % 2 == 1) faces.push_back(f);
        check_manifold(hidden::flipped(faces_only("book", book), faces));
        check_manifold(hidden::flipped(zoo::fan6(), faces));
    }
    // Three and four faces at an edge, but one fan at each of their corners.
    check_shuffled(
        faces_only("three pillows", {{0, 1, 2}, {0, 2, 1}, {2, 0, 1}}));
    check_shuffled(faces_only("two pillows", {{0, 1, 2}, {0, 2, 1}}));
    check_shuffled(faces_only("wall inside", {{0, 1, 2},
                                              {0, 2, 3},
                                              {0, 3, 1},
                                              {1, 3, 2},
                                              {0, 1, 4},
                                              {4, 1, 2},
                                              {0, 4, 2}}));
    check_shuffled(faces_only(
        "no wall inside",
        {{0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {4, 1, 2}, {0, 4, 2}}));
    check_shuffled(zoo::house_with_wall());
    check_shuffled(zoo::house());
}

TEST_CASE("several open fans at a vertex", "[points:2]") {
    hint("Faces at a vertex that share an edge somewhere else: is that a fan?");
    check_shuffled(faces_only("two triangles", {{0, 1, 2}, {0, 3, 4}}));
    check_shuffled(faces_only("one fan", {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    check_shuffled(faces_only("fan of two parts",
                              {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}}));
    // Two corners in common, and no edge.
    check_shuffled(
        faces_only("quads, corner to corner", {{0, 1, 2, 3}, {0, 4, 2, 5}}));
    check_shuffled(
        faces_only("quads, edge to edge", {{0, 1, 2, 3}, {0, 3, 2, 5}}));
    // The edge 2-3 in common, away from vertex 0.
    check_shuffled(faces_only("pentagons, edge and corner",
                              {{0, 1, 2, 3, 4}, {0, 5, 3, 2, 6}}));
    check_shuffled(
        faces_only("pentagons, edge only", {{0, 1, 2, 3, 4}, {7, 5, 3, 2, 6}}));
    check_shuffled(faces_only("ring through a vertex",
                              {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}}));
    check_shuffled(
        faces_only("ring", {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}));
}

TEST_CASE("several closed fans at a vertex", "[points:2]") {
    hint("Are the faces and edges of a vertex counted, or followed?");
    check_shuffled(faces_only("closed fan", hub(5, 0)));
    check_shuffled(faces_only("closed and open fan", hub(5, 2)));
    const Fixture two = hidden::face_list_only(
        "two spheres",
        hidden::side_by_side({zoo::cube().mesh, zoo::tetra().mesh}));
    check_shuffled(two);
    for (int v = 0; v < 8; ++v) check_shuffled(hidden::merged(two, 8, v));
    const Fixture torus_mesh = hidden::face_list_only("torus", torus(6, 5));
    for (const int v : {2 * 5 + 2, 3 * 5 + 2, 4 * 5 + 4})
        check_shuffled(hidden::merged(torus_mesh, 0, v));
    // Pillows that touch in one corner, and pillows sewn together.
    check_shuffled(
        faces_only("pillows", {{0, 1, 2}, {0, 2, 1}, {0, 3, 4}, {0, 4, 3}}));
    check_shuffled(faces_only("bag", {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
}

TEST_CASE("the winding of the faces does not matter", "[points:1]") {
    hint("What do you compare of two faces, besides which edges they have?");
    for (const Fixture& fixture :
         {zoo::cube(), zoo::torus7(), zoo::hourglass(), zoo::annulus(),
          zoo::bow_tie_crossed(), zoo::pillow(), zoo::fan6(), zoo::moebius3q(),
          hidden::pinwheel_across(), zoo::rp2_6()}) {
        for (int f = 0; f < fixture.mesh.faces.size(); ++f)
            check_manifold(hidden::flipped(fixture, {f}));
        check_shuffled(hidden::flipped(fixture, {0, 1}));
    }
    for (int quads = 2; quads <= 6; ++quads) {
        const Fixture band =
            hidden::face_list_only("band", hidden::twisted_band(quads));
        check_shuffled(band);
        check_shuffled(hidden::merged(band, 0, 2 * quads / 2));
    }
}

TEST_CASE("no faces, unused vertices, loose edges", "[points:1]") {
    hint("Which vertices have faces that could form a fan?");
    CHECK(is_manifold(IndexedMesh()));
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(is_manifold({points, {}, {}}));
    CHECK(is_manifold({points, {}, {{0, 1}, {1, 2}}}));
    for (const Fixture& fixture : hidden::all_face_lists()) {
        Fixture more = fixture;
        const int first = fixture.mesh.vertex_count();
        more.mesh.positions.resize(more.mesh.positions.size() + 3);
        check_manifold(more);
        more.mesh.loose_edges = {{0, first}, {first, first + 1}};
        check_manifold(more);
    }
}

TEST_CASE("generated meshes, some of them with two vertices merged",
          "[points:2]") {
    hint("Is it enough that most vertices have one fan?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : generated_fixtures()) {
        for (int k = 0; k < 4; ++k)
            check_manifold(hidden::shuffled(fixture, ++salt));
        for (const auto& [from, to] : pairs(fixture.mesh, 8, ++salt))
            check_manifold(
                hidden::shuffled(hidden::merged(fixture, from, to), salt));
    }
    for (std::uint64_t k = 0; k < 6; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.hole_percent = 15;
        options.bow_ties = k % 2 == 0 ? BowTies::allowed : BowTies::none;
        check_shuffled(
            hidden::face_list_only("generated mesh with holes",
                                   random_polygons(seed() * 100 + k, options)));
    }
}

TEST_CASE("a mesh of many faces", "[points:1][once]") {
    hint("How many faces is each face compared with?");
    const Fixture large = hidden::face_list_only("grid", grid(40, 40));
    CHECK(is_manifold(hidden::shuffled(large, 5).mesh));
    const int inside = 10 * 41 + 10, far = 30 * 41 + 30;
    CHECK_FALSE(is_manifold(
        hidden::shuffled(hidden::merged(large, inside, far), 6).mesh));
}

TEST_CASE("a vertex of many faces", "[points:1][once]") {
    hint("How many faces at the vertex is each of them compared with?");
    CHECK(
        is_manifold(hidden::shuffled(faces_only("hub", hub(6000, 0)), 7).mesh));
}
