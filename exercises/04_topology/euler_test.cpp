#include "exercises/04_topology/euler.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh is a disk: 6 - 8 + 3 is 1", "[points:1]") {
    hint("Which counts go in, and with which signs?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(euler(slide.he) == 1);
}

TEST_CASE("a cube is a sphere, and a ring is none", "[points:1]") {
    hint("What do V, E and F of each of the two meshes give?");
    const Fixture cube = zoo::cube();
    const OnMesh on_cube(cube);
    CHECK(euler(cube.he) == 2);
    const Fixture annulus = zoo::annulus();
    const OnMesh on_annulus(annulus);
    CHECK(euler(annulus.he) == 0);
}
