// Whether a half-edge table keeps its rules.
#pragma once

#include <string>
#include <vector>

#include "course/halfedge/finding.h"
#include "course/halfedge/half_edge_table.h"

namespace course {

/// Every broken rule, by half-edge and then in the order of Fault; empty for a
/// sound table. finding.h says when each is reported. Any numbers may stand in
/// the table: nothing out of range is read, and it always ends.
/// Linear, apart from sorting the loops by face.
std::vector<Finding> validate(const HalfEdgeTable& he);

/// One line: `half-edge 12: opp is 6, but opp of 6 is 7`.
/// Precondition: the finding is one of validate(he).
std::string to_string(const HalfEdgeTable& he, const Finding& finding);

}  // namespace course
