#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"

/// A copy of the table with one edge more, a loose one, with no face on either
/// side: it hangs on the tip of half-edge `border` (the vertex that `border`
/// arrives at) and ends at `new_vertex`. The border walk comes along `border`,
/// goes out to new_vertex, back again, and on where `border` led before.
///
/// Fixed: the two half-edges of the new edge are appended, as rows he.size()
/// and he.size() + 1. `border` gets another `next`. All else stays as it was.
/// Free: which of the two new rows leads out and which leads back.
/// Precondition: the table is valid, no half-edge leaves new_vertex yet, and
/// new_vertex >= 0; vertex numbers may have gaps.
/// Errors: std::invalid_argument when `border` is no row of the table, or lies
/// along a face (its fi is not -1), even if its opposite is on a border.
/// Slide mesh: with_dangling_edge(he, 6, 6) hangs vertex 6 on vertex 4: with
/// the new rows 16 (out) and 17 (back), the walk goes 6, 16, 17, 7.
/// (Lecture "half-edge", slide 181)
HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex);
