#pragma once

#include <vector>

#include "course/halfedge/finding.h"
#include "course/halfedge/half_edge_table.h"

/// Every rule of the table that is broken, with the half-edge that breaks it;
/// empty when none is. The file course/halfedge/finding.h says when exactly a
/// rule is broken, and at which half-edge.
///
/// Rules: all of finding.h but face_in_two_loops, which is never reported.
/// Order: free. A half-edge may break several rules, and then has as many
/// findings; each finding is reported once.
/// Border: the rules hold on the border as in a face; only fi is -1.
/// Precondition: none. The table may be empty, and any number may stand in any
/// cell, so a row must be known to exist before it is read.
/// Cost: at most as many reads as the square of he.size(), times a fixed
/// number; the tables that are given have at most 100 half-edges. Slide mesh:
/// after he[3].next = 1 the findings are next_not_at_tip at 3 and next_shared
/// at 3 and at 5. (Lecture "half-edge", slides 166 and 170)
std::vector<Finding> validate(const HalfEdgeTable& he);
