#include "exercises/05_structures/to_soup.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("two triangles with a common edge", "[points:1]") {
    hint("Which point does the number in a face stand for?");
    const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                           {{0, 1, 2}, {2, 1, 3}},
                           {}};
    const Soup expected = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                           {{{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}}};
    CHECK(to_soup(mesh) == expected);
}

TEST_CASE("the slide mesh has a face with four corners", "[points:1]") {
    hint("What is to happen when a face is no triangle?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(to_soup(slide.mesh), std::invalid_argument);
}
