#include "exercises/04_topology/counts.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh has 6 vertices, 8 edges, 3 faces and 1 loop",
          "[points:1]") {
    hint("How many rows of the table belong to one edge?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(counts(slide.he) == Counts{6, 8, 3, 1});
}

TEST_CASE("a closed mesh has no border loop", "[points:1]") {
    hint("Where is there a loop when every half-edge has a face?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on_tetra(tetra);
    CHECK(counts(tetra.he) == Counts{4, 6, 4, 0});
    const Fixture cube = zoo::cube();
    const OnMesh on_cube(cube);
    CHECK(counts(cube.he) == Counts{8, 12, 6, 0});
}

TEST_CASE("a loose edge is an edge more, and a vertex", "[points:1]") {
    hint("Which of the four counts change when an edge is hung on the border?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK(counts(dangling.he) == Counts{7, 9, 3, 1});
}
