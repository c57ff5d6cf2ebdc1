#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The faces that share an edge with the face of half-edge i.
///
/// Order: free. Each face once, however many edges the two share; never the
/// face itself, and never -1.
/// Border: empty when i lies on the border (there is no face).
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: the number of reads depends on the sides of the face, not on the size
/// of the mesh.
/// Slide mesh: adjacent_faces(he, 4) is {0, 2}, in any order.
/// (Lecture "half-edge", slides 156-157 and 177-178)
std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i);
