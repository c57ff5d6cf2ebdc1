#include "exercises/05_structures/expand_strip.h"

#include <algorithm>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// Each triangle, begun at its smallest vertex.
std::vector<Tri> from_smallest(std::vector<Tri> triangles) {
    for (Tri& t : triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return triangles;
}

}  // namespace

TEST_CASE("a strip of four triangles", "[points:1]") {
    hint("How is every other triangle of the strip wound?");
    CHECK(from_smallest(expand_strip({0, 1, 2, 3, 4, 5})) ==
          std::vector<Tri>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}});
}

TEST_CASE("a vertex that is named twice", "[points:1]") {
    hint("Which places have the triangles that are left out?");
    CHECK(from_smallest(expand_strip({0, 1, 2, 2, 3, 4})) ==
          std::vector<Tri>{{0, 1, 2}, {2, 4, 3}});
}

TEST_CASE("two vertices make no triangle", "[points:1]") {
    hint("What happens when the list is shorter than one triangle?");
    CHECK(expand_strip({3, 4}).empty());
    CHECK(expand_strip({3, 4, 5}).size() == 1);
}
