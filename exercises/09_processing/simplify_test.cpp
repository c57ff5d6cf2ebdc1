#include "exercises/09_processing/simplify.h"

#include "course/halfedge/validate.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh with two faces", "[points:1]") {
    hint(
        "Which edge is the shortest that may be collapsed, and which end "
        "goes?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = simplify(slide.he, slide.mesh.positions, 2);
    CHECK_THAT(he,
               IsTableOf({slide.mesh.positions, {{0, 2, 1}, {1, 2, 5}}, {}}));
}

TEST_CASE("the slide mesh as far as it goes", "[points:1]") {
    hint("What if there are too many faces still, but no edge may go?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = simplify(slide.he, slide.mesh.positions, 0);
    CHECK_THAT(he, IsTableOf({slide.mesh.positions, {{0, 2, 1}}, {}}));
}

TEST_CASE("a mesh with few faces stays as it is", "[points:1]") {
    hint("When is there nothing to do?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(simplify(slide.he, slide.mesh.positions, 3),
               IsTableOf(slide.mesh));
    CHECK_THROWS_AS(simplify(slide.he, slide.mesh.positions, -1),
                    std::invalid_argument);
}
