#include "exercises/09_processing/collapse.h"

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("vertex 4 of the slide mesh goes into vertex 1", "[points:1]") {
    hint("F1 has four sides. Which half-edge comes after which in it now?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = collapse(slide.he, 12);
    CHECK(he.size() == 14);
    CHECK_THAT(
        he, IsTableOf(
                {slide.mesh.positions, {{0, 2, 1}, {1, 2, 5}, {2, 3, 5}}, {}}));
}

TEST_CASE("vertex 3 goes into vertex 5, and the last triangle with it",
          "[points:1]") {
    hint("Which two half-edges that had other opposites belong together now?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = collapse(slide.he, 9);
    CHECK(he.size() == 12);
    CHECK_THAT(
        he, IsTableOf({slide.mesh.positions, {{0, 2, 1}, {1, 2, 5, 4}}, {}}));
}

TEST_CASE("an edge of a cube", "[points:1]") {
    hint("Are the faces on both sides of the edge one side shorter?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    const HalfEdgeTable he = collapse(cube.he, 0);
    CHECK(he.size() == 22);
    REQUIRE(validate(he).empty());
    int triangles = 0;
    for (const FaceList::Face face : to_faces(he))
        triangles += face.size() == 3 ? 1 : 0;
    CHECK(triangles == 2);
}

TEST_CASE("an edge between two faces of the slide mesh is refused",
          "[points:1]") {
    hint("Who tells you whether an edge may be collapsed?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(collapse(slide.he, 8), std::invalid_argument);
    CHECK_THROWS_AS(collapse(slide.he, 16), std::invalid_argument);
}
