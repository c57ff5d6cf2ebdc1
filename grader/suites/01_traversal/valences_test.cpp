// Hidden suite of valences.
#include "exercises/01_traversal/valences.h"

#include <algorithm>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

namespace {

/// The most special place of a vertex in the mesh.
Place place(const Fixture& fixture, const ByFaces& expected) {
    Place most = Place::interior;
    for (int i = 0; i < fixture.he.size(); ++i)
        most = std::max(most, expected.place_of_vertex(i));
    return most;
}

/// Checks a mesh with `more` vertices beside it that nothing leaves.
void check(const Fixture& fixture, const ByFaces& expected, int more) {
    std::map<int, int> histogram = expected.valences();
    if (more > 0) histogram[0] += more;
    REQUIRE(valences(fixture.he, fixture.mesh.vertex_count() + more) ==
            histogram);
}

/// Checks a mesh as it is, and with some such vertices.
void check(const Fixture& fixture) {
    const ByFaces expected(fixture);
    for (const int more : {0, 4}) check(fixture, expected, more);
}

/// Checks the meshes whose most special vertex is in such a place.
void check_where(Place wanted) {
    for (const Fixture& fixture : hidden::made_by_hand()) {
        const OnMesh on(fixture);
        const ByFaces expected(fixture);
        if (place(fixture, expected) == wanted) check(fixture, expected, 0);
    }
}

}  // namespace

TEST_CASE("closed meshes", "[points:2]") {
    hint("How many half-edges leave a vertex with k edges?");
    check_where(Place::interior);
}

TEST_CASE("meshes with a border", "[points:1]") {
    hint("Do you count the edges of a vertex, or its faces?");
    check_where(Place::border);
}

TEST_CASE("meshes with loose edges and bow-ties", "[points:1]") {
    hint("Does your way of counting reach every edge of such a vertex?");
    check_where(Place::degenerate);
}

TEST_CASE("vertices without an edge", "[points:1]") {
    hint("How do you notice a vertex that is in no row of the table?");
    for (const Fixture& fixture : hidden::made_by_hand()) {
        const OnMesh on(fixture);
        const ByFaces expected(fixture);
        for (const int more : {1, 2, 9}) check(fixture, expected, more);
    }
    CHECK(valences({}, 3) == std::map<int, int>{{0, 3}});
    CHECK(valences({}, 0).empty());
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for (const Fixture& fixture : hidden::renumbered_copies()) {
        const OnMesh on(fixture);
        check(fixture);
    }
    on_generated_meshes(generated_fixtures(),
                        [](const Fixture& fixture) { check(fixture); });
}

TEST_CASE("the cost grows no faster than the mesh", "[points:1][once]") {
    hint("How often do you look at each row of the table?");
    constexpr int n = 60;
    const IndexedMesh mesh = grid(n, n);
    const Fixture quads = renumbered({"quads", mesh, build(mesh)});
    // Corners, sides and inside of the grid.
    const std::map<int, int> histogram = {
        {2, 4}, {3, 4 * (n - 1)}, {4, (n - 1) * (n - 1)}};
    const ReadBudget budget(quads.he, 32 * std::int64_t{quads.he.size()});
    CHECK(valences(quads.he, mesh.vertex_count()) == histogram);
}
