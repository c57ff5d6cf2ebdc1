// A half-edge table as text, laid out as on the slides.
#pragma once

#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"

namespace course {

/// A line per half-edge, with - for -1, and a last line with the numbers of
/// vertices (those that a half-edge leaves), edges, faces and border loops. Of
/// a large table only the ends are shown, and a line says how many rows are
/// left out. Any numbers may stand in the table. (Slides 160-164)
std::string describe(const HalfEdgeTable& he);

/// The same with a > before the rows in `marked`, which are always shown;
/// numbers that are no rows are passed over.
std::string describe(const HalfEdgeTable& he, const std::vector<int>& marked);

}  // namespace course
