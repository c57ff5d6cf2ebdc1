#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"

/// The table after the edge of half-edge i, from a to b, has got the new vertex
/// m in its middle. A triangle along the edge is cut in two, from m to its
/// third corner c: (a,b,c) becomes (a,m,c) and (m,b,c). A border along the edge
/// only passes through m. An edge with no face on either side becomes two such
/// edges.
///
/// Fixed: all other vertices and faces keep their numbers; of the two halves of
/// a triangle the one at a (that i leaves) keeps its number, and that at b gets
/// a new one, which no face of the table had. All borders but those along the
/// edge stay as they were.
/// Free: which numbers the new faces get, and how the half-edges of the new
/// table are numbered.
/// Precondition: a valid table in which no face comes to a vertex twice; the
/// numbers of its faces and vertices may have gaps.
/// Errors: std::invalid_argument when i is no row of the table, when a face
/// along the edge is no triangle, when both third corners are one vertex (m and
/// it would be joined twice), and when new_vertex is negative or a half-edge
/// leaves it already.
/// Cost: O(n log n) for n half-edges; linear is possible.
/// Slide mesh: split_edge(he, 1, 6) splits the edge from 0 to 2: F0 = (0,2,1)
/// becomes F0 = (0,6,1) and a new face, (6,2,1). The border passes 2, 6, 0.
/// Two edges more are in the table: 20 half-edges.
/// (Lecture "mesh processing": local operations on a mesh)
HalfEdgeTable split_edge(const HalfEdgeTable& he, int i, int new_vertex);
