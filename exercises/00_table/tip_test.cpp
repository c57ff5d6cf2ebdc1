#include "exercises/00_table/tip.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("half-edges of the slide mesh arrive where the next one leaves",
          "[points:2]") {
    hint("Which vertex is in the row of i, the first or the last of the two?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(tip(slide.he, 4) == 2);
    CHECK(tip(slide.he, 12) == 1);
    CHECK(tip(slide.he, 9) == 5);
}

TEST_CASE("a half-edge on the border arrives at a vertex as well",
          "[points:1]") {
    hint("Which fields does a border half-edge have, and which is -1?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(tip(slide.he, 0) == 0);
    CHECK(tip(slide.he, 10) == 3);
}
