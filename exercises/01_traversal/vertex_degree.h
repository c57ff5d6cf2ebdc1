#pragma once

#include "course/halfedge/half_edge_table.h"

/// Number of edges at the vertex that half-edge i leaves, counted on a walk
/// round it.
///
/// Border: border and loose edges count like any other.
/// Bow-tie (faces that share only this vertex): the edges that the walk from i
/// meets before it is back.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: the number of reads depends on the edges at the vertex and the faces
/// between them, not on the size of the mesh.
/// Slide mesh: vertex_degree(he, 3) == 4. (Lecture "half-edge", slides 173-174)
int vertex_degree(const HalfEdgeTable& he, int i);
