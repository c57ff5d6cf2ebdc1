#include "exercises/04_topology/genus.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh has no handle", "[points:1]") {
    hint("Put the numbers of the slide mesh into the equation: what is left?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(genus(slide.he) == 0);
}

TEST_CASE("a torus has one handle", "[points:1]") {
    hint("What does the equation say when there is no border?");
    const Fixture torus = zoo::torus7();
    const OnMesh on(torus);
    CHECK(genus(torus.he) == 1);
}

TEST_CASE("an annulus has two border loops and no handle", "[points:1]") {
    hint("Which number of the equation tells an annulus from a torus?");
    const Fixture annulus = zoo::annulus();
    const OnMesh on(annulus);
    CHECK(genus(annulus.he) == 0);
}
