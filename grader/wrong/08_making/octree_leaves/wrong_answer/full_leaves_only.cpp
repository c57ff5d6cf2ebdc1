// Leaves the empty leaves out.
// Hint: You leave out the leaves that are empty.
#include "exercises/08_making/octree_leaves.h"

#include <cstdint>

namespace {

bool is_full(const VoxelGrid& grid, int i, int j, int k) {
    return grid.full[static_cast<std::size_t>(i + grid.nx * (j + grid.ny * k))];
}

/// Whether all cells of the cube are like its first one.
bool is_uniform(const VoxelGrid& grid, const OctreeLeaf& cube) {
    for (int k = cube.z; k < cube.z + cube.size; ++k)
        for (int j = cube.y; j < cube.y + cube.size; ++j)
            for (int i = cube.x; i < cube.x + cube.size; ++i)
                if (is_full(grid, i, j, k) != cube.full) return false;
    return true;
}

void divide(const VoxelGrid& grid, OctreeLeaf cube,
            std::vector<OctreeLeaf>& leaves) {
    cube.full = is_full(grid, cube.x, cube.y, cube.z);
    if (is_uniform(grid, cube)) {
        if (cube.full) leaves.push_back(cube);
        return;
    }
    int half = cube.size / 2;
    for (int z : {cube.z, cube.z + half})
        for (int y : {cube.y, cube.y + half})
            for (int x : {cube.x, cube.x + half})
                divide(grid, {x, y, z, half, false}, leaves);
}

void check_sizes(const VoxelGrid& grid) {
    int n = grid.nx;
    bool is_power_of_two = n > 0 && (n & (n - 1)) == 0;
    if (!is_power_of_two || grid.ny != n || grid.nz != n ||
        std::ssize(grid.full) != std::int64_t{n} * n * n)
        throw std::invalid_argument(
            "the grid is no cube whose size is a power of two");
}

}  // namespace

std::vector<OctreeLeaf> octree_leaves(const VoxelGrid& grid) {
    check_sizes(grid);
    std::vector<OctreeLeaf> leaves;
    divide(grid, {0, 0, 0, grid.nx, false}, leaves);
    return leaves;
}
