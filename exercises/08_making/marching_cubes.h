#pragma once

#include <stdexcept>

#include "course/mesh/grids.h"
#include "course/mesh/indexed_mesh.h"
#include "course/mesh/marching_cubes_table.h"

/// The surface where the densities of a grid pass through `level`, as a mesh of
/// triangles. A point of the grid is inside when its density is above the
/// level. The grid's cells are the unit cubes between eight of its points: cell
/// (i, j, k) has the corners (i + x, j + y, k + z) with x, y, z from {0, 1}.
///
/// Vertices: exactly one on each edge of a cell with one end inside and the
/// other not, shared by all cells that have this edge. It lies where the
/// density, taken as linear along the edge, has the value of the level.
/// Triangles: those that cell_triangles has for the cell (see
/// course/mesh/marching_cubes_table.h). Another table is right, too, if it cuts
/// the inside corners of each cell off from the others by triangles between
/// vertices of that cell, with an area, none of them in a side of the cell, and
/// if neighbours meet without a gap: along each side of a triangle runs another
/// one, the other way, but for those in the rim of the grid.
/// Every triangle runs counter-clockwise seen from outside. Where no inside
/// point is at the rim of the grid, the mesh is closed.
/// Free: the numbers of the vertices, the order of the triangles, and where
/// each begins. Loose edges: none.
/// A grid with fewer than two points in some direction has no cells, and gives
/// an empty mesh.
/// Precondition: densities and level are finite; no density is equal to the
/// level, or so near to it that vertices of two edges fall together.
/// Errors: std::invalid_argument when a size is below 0, or there are not
/// nx * ny * nz densities.
/// Cost: linear in the number of points, up to the logarithm of a map.
/// Example: 2 x 2 x 2 points, all 0 but the first, which is 4, at the level 1:
/// the vertices (0.75,0,0), (0,0.75,0), (0,0,0.75) in this order are the one
/// triangle. (Lecture "modelling")
IndexedMesh marching_cubes(const DensityGrid& grid, double level);
