#include "exercises/04_topology/incidences.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh: 10, 10 and 16", "[points:1]") {
    hint("Which rows of the table are not beside a face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(incidences(slide.he) == Incidences{10, 10, 16});
}

TEST_CASE("on a closed mesh all three are the same", "[points:1]") {
    hint("How many faces has an edge there, and how many ends?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on_tetra(tetra);
    CHECK(incidences(tetra.he) == Incidences{12, 12, 12});
    const Fixture house = zoo::house();
    const OnMesh on_house(house);
    CHECK(incidences(house.he) == Incidences{32, 32, 32});
}
