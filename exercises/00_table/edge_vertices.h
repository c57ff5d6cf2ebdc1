#pragma once

#include <array>

#include "course/halfedge/half_edge_table.h"

/// The two vertices of the edge that half-edge i belongs to: first the one that
/// i leaves, then the one that it arrives at.
///
/// Order: fixed, {start, tip}. So i and its opposite give the same two vertices
/// the other way round.
/// Border: a half-edge on the border has two ends like any other.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads, however large the mesh is.
/// Slide mesh: edge_vertices(he, 12) == {4, 1}. (Lecture "half-edge", slide
/// 168)
std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i);
