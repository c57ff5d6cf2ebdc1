// Picture "cubes": marching cubes cell by cell, and the case that can be cut in
// two ways.
#pragma once

#include <array>
#include <vector>

#include "course/mesh/grids.h"
#include "course/mesh/indexed_mesh.h"
#include "course/player/reference.h"
#include "exercises/08_making/marching_cubes.h"

namespace course {

using MarchingCubes = Reference<decltype(marching_cubes)>;

/// What becomes of one cell of a grid.
struct MarchedCell {
    std::array<int, 3> at{};  ///< of its first corner
    int number = 0;    ///< of its case: bit c is set when corner c is inside
    IndexedMesh mesh;  ///< its triangles, by the reference run on it alone
};

/// The cells of the grid that have triangles, along x, then y, then z.
std::vector<MarchedCell> marched_cells(const DensityGrid& grid, double level,
                                       const MarchingCubes& march);

/// A blob of 4 x 4 x 4 points, none of them at the rim inside at level 1.
DensityGrid blob();

/// Two cells whose common side has two inside corners across from each other.
DensityGrid two_cells();

}  // namespace course
