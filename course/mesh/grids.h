// Regular grids of values, from which meshes are made: heights, voxels,
// densities, control points. (Lecture "modelling")
#pragma once

#include <vector>

#include "course/mesh/vec3.h"

/// A height for each point of a plane grid: z[i + nx * j] is the height over
/// the point (i, j), for 0 <= i < nx and 0 <= j < ny. NaN where there is none.
struct HeightGrid {
    int nx = 0, ny = 0;
    std::vector<double> z;

    friend bool operator==(const HeightGrid&, const HeightGrid&) = default;
};

/// Full and empty cells: full[i + nx * (j + ny * k)] tells of the unit cube
/// from the point (i, j, k) to (i + 1, j + 1, k + 1).
struct VoxelGrid {
    int nx = 0, ny = 0, nz = 0;
    std::vector<bool> full;

    friend bool operator==(const VoxelGrid&, const VoxelGrid&) = default;
};

/// A density for each point of a grid in space: density[i + nx * (j + ny * k)]
/// is that of the point (i, j, k).
struct DensityGrid {
    int nx = 0, ny = 0, nz = 0;
    std::vector<double> density;

    friend bool operator==(const DensityGrid&, const DensityGrid&) = default;
};

/// Control points of a surface: points[i + nu * j] is number i in the direction
/// of u, and number j in that of v.
struct ControlGrid {
    int nu = 0, nv = 0;
    std::vector<Vec3> points;

    friend bool operator==(const ControlGrid&, const ControlGrid&) = default;
};
