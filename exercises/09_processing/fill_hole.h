#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"

/// The table after the hole that half-edge `border` runs along is closed: a new
/// vertex m lies in its middle, and each half-edge of this border loop, from u
/// to v, becomes a side of a new triangle (u,v,m).
///
/// Fixed: all other vertices and faces keep their numbers, and all other border
/// loops stay as they are. The new faces get numbers that no face of the table
/// had, each its own.
/// Free: which numbers these are, and how the half-edges of the new table are
/// numbered.
/// Precondition: a valid table; the numbers of its faces and vertices may have
/// gaps.
/// Errors: std::invalid_argument when `border` is no row of the table or lies
/// along a face; when the loop has fewer than three half-edges, or comes to a
/// vertex twice (an edge would be made twice); when new_vertex is negative or a
/// half-edge leaves it already.
/// Cost: O(n log n) for n half-edges; linear is possible.
/// Slide mesh: fill_hole(he, 0, 6) closes the loop 2, 0, 1, 4, 5, 3 with six
/// triangles, (2,0,6), (0,1,6), (1,4,6), (4,5,6), (5,3,6) and (3,2,6): 28
/// half-edges, and no border.
/// (Lecture "mesh processing": cleaning a mesh, holes)
HalfEdgeTable fill_hole(const HalfEdgeTable& he, int border, int new_vertex);
