#include "exercises/04_topology/storage.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh: 10 integers, 64, 73, 73 and 72", "[points:1]") {
    hint("How many records has each structure, and how many numbers in each?");
    CHECK(storage(Counts{6, 8, 3, 1}, 10) == Storage{10, 64, 73, 73, 72});
}

TEST_CASE("a cube: six quads, closed", "[points:1]") {
    hint("Six faces with four corners each: how long are all lists of faces?");
    CHECK(storage(Counts{8, 12, 6, 0}, 24) == Storage{24, 96, 110, 110, 144});
}
