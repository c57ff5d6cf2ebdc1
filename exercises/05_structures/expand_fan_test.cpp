#include "exercises/05_structures/expand_fan.h"

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

TEST_CASE("a fan of three triangles", "[points:1]") {
    hint("Which vertex do all triangles of a fan have in common?");
    CHECK(from_smallest(expand_fan({7, 0, 1, 2, 3})) ==
          std::vector<Tri>{{0, 1, 7}, {1, 2, 7}, {2, 3, 7}});
}

TEST_CASE("two vertices make no triangle", "[points:1]") {
    hint("What happens when the list is shorter than one triangle?");
    CHECK(expand_fan({3, 4}).empty());
    CHECK(expand_fan({3, 4, 5}).size() == 1);
}
