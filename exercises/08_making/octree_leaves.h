#pragma once

#include <stdexcept>
#include <vector>

#include "course/mesh/grids.h"

/// A leaf of an octree: the cells (i, j, k) with x <= i < x + size, and so on
/// for y and z; all of them are full, or all are empty.
struct OctreeLeaf {
    int x = 0, y = 0, z = 0;
    int size = 0;  ///< of its edge, in cells
    bool full = false;

    friend bool operator==(const OctreeLeaf&, const OctreeLeaf&) = default;
};

/// The leaves of the octree of a voxel grid of n * n * n cells. The whole grid
/// is the root. A cube whose cells are all full or all empty is a leaf; any
/// other is divided into eight octants of half its size, and so on with each.
///
/// So a leaf is as large as it can be, leaves do not overlap, and together they
/// are the grid. Leaves of empty cells count, too.
/// Free: the order of the leaves.
/// Errors: std::invalid_argument unless nx, ny and nz are the same power of two
/// (1, 2, 4 ...) and `full` has nx * ny * nz elements.
/// Cost: of the order of the number of cells times the number of levels.
/// Example: a grid of 2 * 2 * 2 with one full cell has eight leaves of size 1;
/// when all its cells are full, it has one, {0, 0, 0, 2, true}.
/// (Lecture "modelling")
std::vector<OctreeLeaf> octree_leaves(const VoxelGrid& grid);
