#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"

/// The table after the edge of half-edge i is flipped. i runs from a to b
/// between the triangles (a,b,c), which it runs along, and (b,a,d); then it
/// runs from d to c, between the triangles (d,c,a) and (c,d,b). So it turns
/// counter-clockwise by one corner of the quad a, d, b, c.
///
/// Fixed: all numbers. i and its opposite are the flipped edge, the face that i
/// runs along and the one across keep their numbers, and so do all other
/// half-edges, faces and vertices: no row but those of the two triangles
/// changes.
/// Precondition: a valid table whose borders do not meet in a vertex; no loose
/// edges; no two edges join the same two vertices, and no face comes to a
/// vertex twice. It holds afterwards, too. Where the vertices are in space is
/// not asked.
/// Errors: std::invalid_argument when i is no row of the table, when the edge
/// has not a triangle on each side, when c and d are one vertex, and when an
/// edge joins c and d already.
/// Cost: linear in the size of the table, to copy it; beyond that, only the
/// edges at c or at d are looked at.
/// Example: a square of the triangles F0 = (0,1,2) and F1 = (0,2,3). Flipping
/// the half-edge from 2 to 0 gives F0 = (3,1,2) and F1 = (1,3,0): it runs from
/// 3 to 1 now. (Lecture "mesh processing": local operations on a mesh)
HalfEdgeTable flip_edge(const HalfEdgeTable& he, int i);
