#include "exercises/04_topology/components.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh is connected", "[points:1]") {
    hint("Can you go from each vertex of the mesh to each other one?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(components(slide.he) == 1);
}

TEST_CASE("two triangles apart are two components", "[points:1]") {
    hint("When the first search is done, which vertices has it not reached?");
    const Fixture two = zoo::two_triangles();
    const OnMesh on(two);
    CHECK(components(two.he) == 2);
}

TEST_CASE("a mesh with two border loops may be one component", "[points:1]") {
    hint("Do you count what hangs together, or where it ends?");
    const Fixture annulus = zoo::annulus();
    const OnMesh on(annulus);
    CHECK(components(annulus.he) == 1);
}
