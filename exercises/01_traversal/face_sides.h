#pragma once

#include "course/halfedge/half_edge_table.h"

/// Number of sides of the face that half-edge i runs along. An edge with this
/// face on both sides counts twice.
///
/// Border: 0 when i lies on the border (there is no face to count).
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads for each side, however large the mesh is.
/// Slide mesh: face_sides(he, 4) == 4. (Lecture "half-edge", slides 171-172)
int face_sides(const HalfEdgeTable& he, int i);
