#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"
#include "exercises/09_processing/can_collapse.h"

/// The table after the edge of half-edge i is collapsed: the vertex that i
/// leaves goes, and all its other edges end at the tip of i now. The edge
/// vanishes. A triangle along it vanishes, too, and its two other sides become
/// one edge; a larger face, or a border, along it loses a side.
///
/// Fixed: the tip of i and all other vertices keep their numbers, and so do the
/// faces that stay (positions and colours beside the table remain right): the
/// number of what has gone is left out. The rows of what has gone are no longer
/// in the table.
/// Free: how the half-edges of the new table are numbered.
/// Precondition: that of can_collapse, which you may call: in grading, it is a
/// right one.
/// Errors: std::invalid_argument when can_collapse(he, i) is false.
/// Cost: O(n log n) for n half-edges; linear is possible.
/// Slide mesh: collapse(he, 12) pulls vertex 4 into vertex 1. F1 is (1,2,5)
/// now, F0 and F2 are as before, and 14 half-edges are left. collapse(he, 1)
/// pulls vertex 0 into vertex 2: F0 goes, F1 and F2 are as before, and 12
/// half-edges are left.
/// (Lecture "mesh processing": simplification by edge collapse)
HalfEdgeTable collapse(const HalfEdgeTable& he, int i);
