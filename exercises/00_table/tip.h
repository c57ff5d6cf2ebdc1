#pragma once

#include "course/halfedge/half_edge_table.h"

/// The vertex that half-edge i arrives at.
///
/// The table has no field for it, but tells it in two ways; either may be used.
/// Border: a half-edge on the border arrives at a vertex like any other.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads, however large the mesh is.
/// Slide mesh: tip(he, 4) == 2. (Lecture "half-edge", slides 166 and 168)
int tip(const HalfEdgeTable& he, int i);
