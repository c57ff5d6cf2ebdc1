#include "exercises/09_processing/can_collapse.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh: all edges but the two between faces", "[points:1]") {
    hint("On which vertices of this mesh do you not meet the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    for (int i = 0; i < 16; ++i) {
        INFO("half-edge " << i);
        const bool inside = i == 3 || i == 4 || i == 8 || i == 11;
        CHECK(can_collapse(slide.he, i) == !inside);
    }
}

TEST_CASE("no edge of a tetrahedron", "[points:1]") {
    hint("Six edges, and what would be left? Count those at the one vertex.");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    for (int i = 0; i < 12; ++i) CHECK_FALSE(can_collapse(tetra.he, i));
}

TEST_CASE("each edge of a cube", "[points:1]") {
    hint("A quad along the edge only loses a side. Is anything in the way?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    for (int i = 0; i < 24; ++i) CHECK(can_collapse(cube.he, i));
}
