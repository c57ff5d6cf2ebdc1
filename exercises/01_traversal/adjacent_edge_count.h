#pragma once

#include "course/halfedge/half_edge_table.h"

/// Number of sides of the face of half-edge i that have a face on the other
/// side too.
///
/// Sides are counted, not faces: a neighbour along two sides counts twice, and
/// so does an edge with this very face on both sides.
/// Border: 0 when i lies on the border (there is no face).
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: the number of reads depends on the sides of the face, not on the size
/// of the mesh.
/// Slide mesh: adjacent_edge_count(he, 4) == 2.
/// (Lecture "half-edge", slides 177-178)
int adjacent_edge_count(const HalfEdgeTable& he, int i);
