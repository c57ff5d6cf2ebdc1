#include "exercises/09_processing/simplify_quadric.h"

#include <set>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

/// The triangles of a table that has nothing else; no face twice.
int triangles(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (const HalfEdge& row : he.rows())
        if (row.fi != -1) faces.insert(row.fi);
    return static_cast<int>(faces.size());
}

}  // namespace

TEST_CASE("the middle of a flat square goes, the border stays", "[points:1]") {
    hint("All errors are 0 here. What else decides which pull comes first?");
    const IndexedMesh mesh = grid(2, 2, Cells::triangles);
    const Fixture fixture{"2 x 2 squares", mesh, build(mesh)};
    const OnMesh on(fixture);
    const HalfEdgeTable he = simplify_quadric(fixture.he, mesh.positions, 0);
    REQUIRE(validate(he).empty());
    CHECK(triangles(he) == 6);
    std::set<int> vertices;
    for (const HalfEdge& row : he.rows()) vertices.insert(row.vi);
    CHECK(vertices == std::set{0, 1, 2, 3, 5, 6, 7, 8});
}

TEST_CASE("a flat apex is missed less than a high one", "[points:1]") {
    hint("Which planes has each apex, and how far is a neighbour from them?");
    // A ring 0, 1, 2, 3 between the apexes 4, far above, and 5, just below.
    const IndexedMesh mesh{
        {{3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0}, {0, 0, 9}, {0, 0, -1}},
        {{0, 1, 4},
         {1, 2, 4},
         {2, 3, 4},
         {3, 0, 4},
         {1, 0, 5},
         {2, 1, 5},
         {3, 2, 5},
         {0, 3, 5}},
        {}};
    const Fixture fixture{"two pyramids", mesh, build(mesh)};
    const OnMesh on(fixture);
    const HalfEdgeTable he = simplify_quadric(fixture.he, mesh.positions, 6);
    REQUIRE(validate(he).empty());
    CHECK(triangles(he) == 6);
    for (const HalfEdge& row : he.rows()) CHECK(row.vi != 5);
}

TEST_CASE("a quad is refused", "[points:1]") {
    hint("What must be known about the faces before the first error?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    CHECK_THROWS_AS(simplify_quadric(cube.he, cube.mesh.positions, 4),
                    std::invalid_argument);
}
