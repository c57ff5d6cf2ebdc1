#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// All border loops of the mesh: for each loop the indices of its half-edges,
/// each once, in the order in which `next` meets them. Every half-edge without
/// a face is in exactly one loop.
///
/// Fixed: the direction within a loop (that of `next`). Free: where a loop
/// begins, and the order of the loops.
/// Border: a closed mesh and an empty table have no loop, the result is empty.
/// A loose edge that hangs on a border is part of that loop, passed on both
/// sides; one that hangs on nothing is a loop of two half-edges.
/// Precondition: the table is valid.
/// Cost: a fixed number of reads for each half-edge of the table, however long
/// the loops are.
/// Slide mesh: one loop, {0, 2, 6, 7, 10, 13} or a rotation of it.
/// (Lecture "half-edge", slides 179-181; notes on modelling: a border is one
/// loop or several)
std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he);
