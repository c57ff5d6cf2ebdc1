#pragma once

#include <stdexcept>

#include "course/mesh/grids.h"
#include "course/mesh/indexed_mesh.h"

/// The surface of the full cells of a voxel grid, as a mesh of unit squares:
/// one quad wherever a full cell meets an empty one, or the end of the grid,
/// beyond which all is empty. None between two full cells, none between two
/// empty ones.
///
/// Vertices: the corners of these squares, at whole coordinates (the cell
/// (i, j, k) reaches from (i, j, k) to (i + 1, j + 1, k + 1)). One vertex for
/// each place, whatever meets there, and none that no quad uses.
/// Quads: each runs counter-clockwise seen from the empty side, so that the
/// surface is wound outwards.
/// Free: the numbers of the vertices, the order of the quads, and the corner at
/// which each begins. Loose edges: none.
/// Where full cells touch at an edge only, four quads share that edge, and the
/// surface is no 2-manifold there; that is as it should be.
/// A grid without full cells, or of no cells at all, gives an empty mesh.
/// Errors: std::invalid_argument when a size is below 0, or `full` does not
/// have nx * ny * nz elements.
/// Cost: linear in the number of cells, up to the logarithm of a map.
/// Example: one full cell in a grid of one gives the cube, 8 vertices and 6
/// quads; two side by side give 12 vertices and 10 quads.
/// (Lecture "modelling")
IndexedMesh voxel_surface(const VoxelGrid& grid);
