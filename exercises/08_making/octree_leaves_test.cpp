#include "exercises/08_making/octree_leaves.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("one full cell in a grid of two", "[points:1]") {
    hint(
        "Into which eight cubes is the grid divided, and which of them is "
        "full?");
    VoxelGrid grid{2, 2, 2, std::vector<bool>(8)};
    grid.full[1] = true;
    auto leaves = octree_leaves(grid);
    std::sort(leaves.begin(), leaves.end(),
              [](const OctreeLeaf& a, const OctreeLeaf& b) {
                  return std::array{a.z, a.y, a.x} < std::array{b.z, b.y, b.x};
              });
    CHECK(leaves == std::vector<OctreeLeaf>{{0, 0, 0, 1, false},
                                            {1, 0, 0, 1, true},
                                            {0, 1, 0, 1, false},
                                            {1, 1, 0, 1, false},
                                            {0, 0, 1, 1, false},
                                            {1, 0, 1, 1, false},
                                            {0, 1, 1, 1, false},
                                            {1, 1, 1, 1, false}});
}

TEST_CASE("a full grid is one leaf", "[points:1]") {
    hint("When is there nothing to divide?");
    CHECK(octree_leaves({4, 4, 4, std::vector<bool>(64, true)}) ==
          std::vector<OctreeLeaf>{{0, 0, 0, 4, true}});
}

TEST_CASE("a grid of three is refused", "[points:1]") {
    hint("What is half of three?");
    CHECK_THROWS_AS(octree_leaves({3, 3, 3, std::vector<bool>(27)}),
                    std::invalid_argument);
}
