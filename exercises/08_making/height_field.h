#pragma once

#include <stdexcept>

#include "course/mesh/grids.h"
#include "course/mesh/indexed_mesh.h"

/// A terrain of triangles from a grid of heights; NaN is a hole in it.
///
/// Vertices: one for each point (i, j) of the grid that has a height, at
/// (i, j, z[i + nx * j]), in the order in which the heights stand in z, whether
/// a triangle uses it or not. Points without a height give no vertex, so that
/// those after them get smaller numbers.
/// Triangles: each cell of the grid between four neighbouring points (i, j),
/// (i + 1, j), (i + 1, j + 1), (i, j + 1) gives two triangles, cut along one of
/// its diagonals, when all four have a height; the one triangle of the other
/// three, when exactly one is NaN; and else none. Every triangle runs counter-
/// clockwise seen from above, from where z is large.
///
/// Free: along which diagonal a cell with four heights is cut, the order of the
/// triangles, and where each begins. Loose edges: none.
/// A grid with fewer than two rows or columns has no cells; one of no points at
/// all gives an empty mesh. Heights are finite or NaN; 0 and numbers below 0
/// are heights as others are.
/// Errors: std::invalid_argument when nx or ny is below 0, or z does not have
/// nx * ny elements.
/// Cost: linear in nx * ny.
/// Example: nx = 2, ny = 2, z = {5, 6, NaN, 8} has the vertices (0,0,5),
/// (1,0,6), (1,1,8) and the triangle (0,1,2). (Lecture "modelling")
IndexedMesh height_field(const HeightGrid& grid);
