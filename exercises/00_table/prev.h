#pragma once

#include "course/halfedge/half_edge_table.h"

/// The half-edge before i: the one whose next is i. In a valid table there is
/// exactly one.
///
/// Border: a border half-edge is preceded by a border half-edge of its loop.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads for each half-edge of the face or border loop
/// that i is on and for each half-edge that leaves the vertex of i; so both a
/// walk along the loop and a turn round the vertex are right, and looking
/// through the table is not.
/// Slide mesh: prev(he, 4) == 12. (Lecture "half-edge", slide 166)
int prev(const HalfEdgeTable& he, int i);
