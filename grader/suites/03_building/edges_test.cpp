// Hidden suite of edges. What is expected comes from asking each pair of
// vertices, or is worked out by hand.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <tuple>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Edges = std::vector<EdgeInfo>;

/// The smaller end first, and the edges in order.
Edges in_order(Edges list) {
    for (EdgeInfo& edge : list)
        if (edge.a > edge.b) std::swap(edge.a, edge.b);
    std::sort(list.begin(), list.end(), [](EdgeInfo x, EdgeInfo y) {
        return std::tie(x.a, x.b, x.faces) < std::tie(y.a, y.b, y.faces);
    });
    return list;
}

/// How many sides of the face join vertices a and b.
int sides_between(FaceList::Face face, int a, int b) {
    int sides = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        const int from = face[k];
        const int to = face[k + 1 == face.size() ? 0 : k + 1];
        sides += (from == a && to == b) || (from == b && to == a);
    }
    return sides;
}

Edges expected_edges(const IndexedMesh& mesh) {
    Edges expected;
    for (int a = 0; a < mesh.vertex_count(); ++a) {
        std::vector<FaceList::Face> faces;
        for (const FaceList::Face face : mesh.faces)
            if (std::count(face.begin(), face.end(), a)) faces.push_back(face);
        for (int b = a + 1; b < mesh.vertex_count(); ++b) {
            int sides = 0;
            for (const FaceList::Face face : faces)
                sides += sides_between(face, a, b);
            if (sides > 0) expected.push_back({a, b, sides});
        }
    }
    for (const auto& [a, b] : mesh.loose_edges) expected.push_back({a, b, 0});
    return in_order(expected);
}

void check_edges(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(in_order(edges(fixture.mesh)) == expected_edges(fixture.mesh));
}

/// As it is, and put down in another way.
void check_both(const Fixture& fixture, std::uint64_t salt = 1) {
    check_edges(fixture);
    check_edges(hidden::put_in_another_order(fixture, salt));
}

}  // namespace

TEST_CASE("closed meshes: two faces at each edge", "[points:1]") {
    hint("Does each edge come once, and with both of its faces?");
    for (const Fixture& fixture : hidden::closed_meshes()) check_both(fixture);
}

TEST_CASE("open meshes: one face at an edge of the border", "[points:2]") {
    hint("Which sides of faces have no other side along the same edge?");
    for (const Fixture& fixture : hidden::open_meshes_with_table())
        check_both(fixture);
}

TEST_CASE("faces wound any way", "[points:1]") {
    hint("Two faces may run along an edge alike. Is it one edge or two?");
    for (const Fixture& fixture :
         {zoo::moebius3q(), zoo::moebius5(), zoo::klein4x4(), zoo::rp2_6()})
        check_both(fixture);
    check_both(hidden::with_faces_reversed(zoo::cube(), {0, 3}));
    check_both(hidden::with_faces_reversed(zoo::slide(), {1}));
}

TEST_CASE("more than two faces at an edge", "[points:1]") {
    hint("Is there a place in your code that knows only two faces?");
    for (const Fixture& fixture : {zoo::fan3(), zoo::house_with_wall()})
        check_both(fixture);
    check_both(hidden::of_faces(
        "five pages", 7,
        {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 0, 1}, {0, 6, 1}}));
    check_both(hidden::of_faces("three times the same", 3,
                                {{0, 1, 2}, {1, 2, 0}, {0, 2, 1}}));
}

TEST_CASE("a face that runs along an edge twice", "[points:1]") {
    hint("Do you count faces, or sides of faces?");
    for (const Fixture& fixture :
         {hidden::spur(), hidden::keyhole(), hidden::pinched_sphere()})
        check_both(fixture);
}

TEST_CASE("loose edges, unused vertices, and nothing at all", "[points:2]") {
    hint("Which edges belong to no face, and what is their count?");
    check_edges(hidden::of_mesh("nothing", {}));
    check_edges(hidden::of_mesh("points", {std::vector<Vec3>(5), {}, {}}));
    check_both(hidden::of_mesh("loose edges only",
                               {std::vector<Vec3>(6), {}, {{4, 1}, {1, 3}}}));
    check_both(hidden::gaps());
    for (const Fixture& fixture : hidden::with_loose_edges())
        check_both(fixture);
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Faces of three to eight sides: does each have a last side, too?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_closed())
        check_both(fixture, ++salt);
    for (const Fixture& fixture : hidden::generated_open())
        check_both(fixture, ++salt);
}

TEST_CASE("large vertex numbers", "[points:1]") {
    hint("Can two different edges end up under the same name?");
    IndexedMesh mesh{std::vector<Vec3>(140'000), {}, {}};
    mesh.faces = {{0, 65'536, 131'072}, {65'536, 0, 139'999}, {1, 0, 65'535}};
    mesh.loose_edges = {{1, 65'536}, {99'999, 100'000}};
    CHECK(in_order(edges(mesh)) == in_order({{0, 65'536, 2},
                                             {65'536, 131'072, 1},
                                             {131'072, 0, 1},
                                             {0, 139'999, 1},
                                             {65'536, 139'999, 1},
                                             {1, 0, 1},
                                             {0, 65'535, 1},
                                             {1, 65'535, 1},
                                             {1, 65'536, 0},
                                             {99'999, 100'000, 0}}));
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How often do you look at each edge that you have already?");
    constexpr int n = 100;
    Edges expected;
    for (int row = 0; row <= n; ++row)
        for (int k = 0; k < n; ++k) {
            const int faces = row == 0 || row == n ? 1 : 2;
            const int v = row * (n + 1) + k, w = k * (n + 1) + row;
            expected.push_back({v, v + 1, faces});
            expected.push_back({w, w + n + 1, faces});
        }
    const bool same = in_order(edges(grid(n, n))) == in_order(expected);
    CHECK(same);
}
