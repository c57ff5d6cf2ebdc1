#pragma once

#include <optional>

#include "course/halfedge/half_edge_table.h"

/// The face on the other side of the edge of half-edge i: the one that the
/// opposite half-edge runs along.
///
/// Border: std::nullopt when there is no face on the other side. A half-edge
/// that itself lies on the border gets the face beyond it, if there is one.
/// A face that lies on both sides of the edge is its own face across.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads, however large the mesh is.
/// Slide mesh: face_across(he, 4) == 0. (Lecture "half-edge", slides 156-157)
std::optional<int> face_across(const HalfEdgeTable& he, int i);
