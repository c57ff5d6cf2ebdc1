#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The star of the vertex that half-edge i leaves: the vertices at the other
/// end of its edges, each once.
///
/// Order: that of the slide's walk, opp and then next, again and again.
/// Where it begins is free: any rotation of the list is right. The other way
/// round is not.
/// Border: a gap between the faces does not end the walk; border and loose
/// edges count like any other.
/// Bow-tie (faces that share only this vertex): those that the walk from i
/// meets before it is back.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: the number of reads depends on the edges at the vertex and the faces
/// between them, not on the size of the mesh.
/// Slide mesh: vertex_star(he, 3) is {1, 5, 3, 0}, begun anywhere.
/// (Lecture "half-edge", slides 173-174)
std::vector<int> vertex_star(const HalfEdgeTable& he, int i);
