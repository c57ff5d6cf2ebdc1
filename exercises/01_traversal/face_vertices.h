#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The vertices of the face that half-edge i runs along, one for each side.
///
/// Order: fixed. The first is the vertex that i leaves, then in the direction
/// of next.
/// Border: empty when i lies on the border (there is no face).
/// A vertex that the face passes twice is listed twice.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads for each side, however large the mesh is.
/// Slide mesh: face_vertices(he, 4) is {1, 2, 5, 4}.
/// (Lecture "half-edge", slides 156-158 and 171-172)
std::vector<int> face_vertices(const HalfEdgeTable& he, int i);
