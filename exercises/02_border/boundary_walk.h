#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The border loop at the edge of half-edge i: the indices of its half-edges,
/// each once, in the order in which `next` meets them.
///
/// Start: when i has no face, the loop that i lies on. Otherwise the loop of
/// its opposite, when that has no face. Otherwise there is no border at this
/// edge, and the result is empty. Only this one loop: the mesh may have more.
/// Fixed: the direction (that of `next`). Free: where in the loop you begin.
/// A loose edge is passed twice, once on each of its sides.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads for each half-edge of the loop, and a fixed
/// number when there is none, however large the mesh is.
/// Slide mesh: boundary_walk(he, 7) is {7, 10, 13, 0, 2, 6} or a rotation of
/// it, and so is boundary_walk(he, 15). (Lecture "half-edge", slides 179-181)
std::vector<int> boundary_walk(const HalfEdgeTable& he, int i);
