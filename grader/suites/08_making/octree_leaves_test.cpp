// Hidden suite of octree_leaves: what the leaves must have in common, whatever
// their order. That fixes them.
#include "exercises/08_making/octree_leaves.h"

#include <random>

#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

using Leaves = std::vector<OctreeLeaf>;

std::size_t place(const VoxelGrid& grid, int x, int y, int z) {
    return static_cast<std::size_t>((z * grid.nx + y) * grid.nx + x);
}

bool is_octant(const OctreeLeaf& leaf, int n) {
    for (int size = n; size > 0; size /= 2)
        if (leaf.size == size)
            for (const int at : {leaf.x, leaf.y, leaf.z})
                if (at < 0 || at > n - size || at % size != 0) return false;
    return 0 < leaf.size && leaf.size <= n && n % leaf.size == 0;
}

template <class F>
void for_each_cell(const VoxelGrid& grid, const OctreeLeaf& leaf, F f) {
    for (int z = leaf.z; z < leaf.z + leaf.size; ++z)
        for (int y = leaf.y; y < leaf.y + leaf.size; ++y)
            for (int x = leaf.x; x < leaf.x + leaf.size; ++x)
                f(place(grid, x, y, z));
}

/// How many cells of the cube are full.
int count_full(const VoxelGrid& grid, const OctreeLeaf& cube) {
    int count = 0;
    for_each_cell(grid, cube,
                  [&](std::size_t cell) { count += grid.full[cell]; });
    return count;
}

/// The cube of which this one is an octant.
OctreeLeaf parent(OctreeLeaf leaf) {
    leaf.size *= 2;
    for (int* at : {&leaf.x, &leaf.y, &leaf.z}) *at -= *at % leaf.size;
    return leaf;
}

bool is_mixed(const VoxelGrid& grid, const OctreeLeaf& cube) {
    const int full = count_full(grid, cube);
    return full != 0 && full != cube.size * cube.size * cube.size;
}

std::string bad_leaf(const VoxelGrid& grid, const OctreeLeaf& leaf) {
    if (!is_octant(leaf, grid.nx)) return "is no octant of the grid";
    if (is_mixed(grid, leaf)) return "has full and empty cells";
    if (leaf.full != (count_full(grid, leaf) > 0))
        return leaf.full ? "is empty in truth" : "is full in truth";
    if (leaf.size < grid.nx && !is_mixed(grid, parent(leaf)))
        return "is part of a larger cube whose cells are alike";
    return "";
}

std::string fault(const VoxelGrid& grid, const Leaves& leaves) {
    std::vector<bool> covered(grid.full.size());
    for (const OctreeLeaf& leaf : leaves) {
        std::string why = bad_leaf(grid, leaf);
        if (why.empty())
            for_each_cell(grid, leaf, [&](std::size_t cell) {
                if (covered[cell]) why = "overlaps another one";
                covered[cell] = true;
            });
        if (!why.empty()) return "the leaf " + show(leaf) + " " + why;
    }
    const auto left = std::count(covered.begin(), covered.end(), false);
    if (left == 0) return "";
    return std::to_string(left) + " cells are in no leaf";
}

oracle::FaultMatcher<Leaves> AreLeavesOf(const VoxelGrid& grid) {
    return {"the leaves of the octree",
            [=](const Leaves& leaves) { return fault(grid, leaves); }};
}

void check(const VoxelGrid& grid) {
    REQUIRE_THAT(octree_leaves(grid), AreLeavesOf(grid));
}

VoxelGrid all(int n, bool full) {
    return {n, n, n,
            std::vector<bool>(static_cast<std::size_t>(n * n * n), full)};
}

VoxelGrid with(VoxelGrid grid, int x, int y, int z) {
    grid.full[place(grid, x, y, z)].flip();
    return grid;
}

VoxelGrid random_grid(int n, int percent, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    VoxelGrid grid = all(n, false);
    for (std::size_t k = 0; k < grid.full.size(); ++k)
        grid.full[k] = static_cast<int>(next() % 100) < percent;
    return grid;
}

/// Octants of any size, filled at random: leaves of all sizes.
VoxelGrid random_blocks(int n, int blocks, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    VoxelGrid grid = all(n, false);
    for (int k = 0; k < blocks; ++k) {
        const int size = 1 << next() % 3;
        const auto at = [&] {
            const auto parts = static_cast<std::uint64_t>(n / size);
            return size * static_cast<int>(next() % parts);
        };
        const int x = at(), y = at(), z = at();
        const bool full = next() % 3 != 0;
        for_each_cell(grid, {x, y, z, size, full},
                      [&](std::size_t cell) { grid.full[cell] = full; });
    }
    return grid;
}

VoxelGrid checkerboard(int n) {
    VoxelGrid grid = all(n, false);
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                grid.full[place(grid, x, y, z)] = (x + y + z) % 2 == 0;
    return grid;
}

}  // namespace

TEST_CASE("one cell differs from all others", "[points:2]") {
    hint("Which cubes are divided, and which stay whole?");
    for (const bool full : {false, true}) {
        for (int k = 0; k < 8; ++k)
            check(with(all(2, full), k & 1, k >> 1 & 1, k >> 2));
        for (int k = 0; k < 64; ++k)
            check(with(all(4, full), k % 4, k / 4 % 4, k / 16));
        check(with(all(8, full), 7, 7, 7));
        check(with(all(8, full), 3, 4, 5));
        check(with(all(16, full), 8, 7, 0));
    }
}

TEST_CASE("blocks that are octants, and blocks that are not", "[points:2]") {
    hint("Can cells of different octants ever be in the same leaf?");
    VoxelGrid aligned = all(8, false), across = all(8, false);
    for_each_cell(aligned, {4, 0, 4, 4, true},
                  [&](std::size_t cell) { aligned.full[cell] = true; });
    for_each_cell(across, {2, 3, 1, 4, true},
                  [&](std::size_t cell) { across.full[cell] = true; });
    check(aligned);
    check(across);
    for (std::uint64_t salt = 0; salt < 20; ++salt)
        check(random_blocks(8, 2 + static_cast<int>(salt), salt));
}

TEST_CASE("layers along each direction", "[points:1]") {
    hint("Where in the list is the cell (i, j, k)?");
    for (int layer = 0; layer < 4; ++layer)
        for (int axis = 0; axis < 3; ++axis) {
            VoxelGrid grid = all(4, false);
            for (int k = 0; k < 64; ++k) {
                const int at[] = {k % 4, k / 4 % 4, k / 16};
                grid.full[static_cast<std::size_t>(k)] = at[axis] == layer;
            }
            check(grid);
        }
}

TEST_CASE("random cells", "[points:2]") {
    hint(
        "Is each cell in exactly one leaf? Is each leaf as large as possible?");
    for (std::uint64_t salt = 30; salt < 50; ++salt) {
        const int percent = 5 * static_cast<int>(salt - 30);
        check(random_grid(4, percent, salt));
        check(random_grid(2, percent, salt));
    }
    check(random_grid(8, 50, 50));
    check(random_grid(8, 99, 51));
}

TEST_CASE("one leaf, and as many leaves as cells", "[points:1]") {
    hint("When is the whole grid a leaf? What is the smallest cube?");
    for (const int n : {1, 2, 4, 8, 16})
        for (const bool full : {false, true}) check(all(n, full));
    for (const int n : {2, 4, 8}) check(checkerboard(n));
}

TEST_CASE("sizes that do not fit are refused", "[points:1]") {
    hint("Which sizes can be halved until 1 is left?");
    for (const int n : {3, 5, 6, 7, 9, 10, 12, 15})
        CHECK_THROWS_AS(octree_leaves(all(n, true)), std::invalid_argument);
    const std::vector<bool> eight(8, true), none;
    for (const VoxelGrid& grid :
         {VoxelGrid{0, 0, 0, none}, VoxelGrid{2, 2, 2, none},
          VoxelGrid{4, 2, 1, eight}, VoxelGrid{1, 1, 8, eight},
          VoxelGrid{2, 1, 4, eight}, VoxelGrid{8, 1, 1, eight},
          VoxelGrid{-2, -2, 2, eight}, VoxelGrid{1, 1, 1, eight},
          VoxelGrid{2, 2, 1, std::vector<bool>(4)}, VoxelGrid{4, 4, 4, eight},
          VoxelGrid{2, 2, 4, eight}, VoxelGrid{-1, -1, -1, {}}})
        CHECK_THROWS_AS(octree_leaves(grid), std::invalid_argument);
}

TEST_CASE("the cost grows little faster than the grid", "[points:1][once]") {
    hint("How often is each cell looked at?");
    check(checkerboard(16));
    for (std::uint64_t salt = 60; salt < 66; ++salt) {
        check(random_grid(16, 50, salt));
        check(random_blocks(16, 40, salt));
    }
}
