#include "exercises/02_border/boundary_loops.h"

#include "course/runner/border_by_faces.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh has one border loop of six", "[points:1]") {
    hint("Six half-edges lie on the border. How many loops do they make?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(boundary_loops(slide.he), AreLoops({{0, 2, 6, 7, 10, 13}}));
}

TEST_CASE("a ring of three quads has two loops of three", "[points:1]") {
    hint("When the first loop is done, where do you look for the next one?");
    const Fixture annulus = zoo::annulus();
    const OnMesh on(annulus);
    const std::vector<std::vector<int>> loops = boundary_loops(annulus.he);
    REQUIRE(loops.size() == 2);
    CHECK(loops[0].size() == 3);
    CHECK(loops[1].size() == 3);
}

TEST_CASE("a cube has no border", "[points:1]") {
    hint("Does any half-edge of a closed mesh lack a face?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    CHECK(boundary_loops(cube.he).empty());
}

TEST_CASE("all border loops, on generated meshes", "[points:1]") {
    hint(
        "Does every half-edge without a face stand in exactly one of your "
        "loops?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        REQUIRE_THAT(boundary_loops(mesh.he),
                     AreLoops(oracle::Border(mesh).loops()));
    });
}
