#include "exercises/09_processing/smooth.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the middle of a fan moves to the mean of the rim", "[points:1]") {
    hint(
        "What is the mean of the six neighbours, and how far is half the way?");
    const Fixture fan = zoo::fan6();
    const OnMesh on(fan);
    std::vector<Vec3> lifted = fan.mesh.positions;
    lifted[0] = {0, 0, 3};
    std::vector<Vec3> expected = lifted;
    expected[0] = {0, 0, 1.5};
    CHECK_THAT(smooth(fan.he, lifted, 1, 0.5), AreAt(expected, 4));
    expected[0] = {0, 0, 0.75};
    CHECK_THAT(smooth(fan.he, lifted, 2, 0.5), AreAt(expected, 4));
}

TEST_CASE("all vertices of a closed mesh move at once", "[points:1]") {
    hint("Where were the neighbours before this step began?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    std::vector<Vec3> expected;
    for (const Vec3 p : tetra.mesh.positions)
        expected.push_back(-1.0 / 3 * p);  // the four add up to 0
    CHECK_THAT(smooth(tetra.he, tetra.mesh.positions, 1, 1),
               AreAt(expected, 4));
}

TEST_CASE("a mesh whose vertices are all on the border stays", "[points:1]") {
    hint("How does the table show that a vertex lies on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(smooth(slide.he, slide.mesh.positions, 3, 0.5) ==
          slide.mesh.positions);
}
