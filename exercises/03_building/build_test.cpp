#include "exercises/03_building/build.h"

#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("one triangle has three half-edges on the border", "[points:1]") {
    hint("Which half-edges run along no face, and which one follows which?");
    const Fixture triangle = zoo::triangle();
    const OnMesh on(triangle);
    CHECK_THAT(::build(triangle.mesh), IsTableOf(triangle.mesh));
}

TEST_CASE("the slide mesh", "[points:1]") {
    hint("Is each half-edge the next of exactly one other?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(::build(slide.mesh), IsTableOf(slide.mesh));
}

TEST_CASE("three faces at one edge are refused", "[points:1]") {
    hint("How do you notice that an edge has both its faces already?");
    const Fixture fan3 = zoo::fan3();
    const OnMesh on(fan3);
    CHECK_THROWS_AS(::build(fan3.mesh), std::invalid_argument);
}
