#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// A triangle strip that begins with the triangle of half-edge i and takes one
/// triangle after the other as long as it can: the numbers of its vertices.
///
/// The strip begins with the start of i, its tip, and the third vertex of the
/// triangle. Then, again and again: the next triangle lies across the edge
/// between the last two vertices of the strip, and its third vertex is
/// appended. The strip ends when there is no face across that edge, or one that
/// the strip has already. Nothing is left free.
/// So `expand_strip` makes triangles of the mesh of it, each once, wound as in
/// the mesh.
/// Border: empty when i has no face (its fi is -1).
/// Precondition: the table is valid, every face is a triangle, and i is one of
/// its rows. Loose edges and bow-ties are allowed.
/// Cost: at most 20 reads for each triangle of the strip, and 20 more.
/// Example: on the tetrahedron with the faces (1,2,3) (1,0,2) (3,2,0) (0,1,3),
/// the strip from the half-edge that runs from 1 to 2 along the first face is
/// {1, 2, 3, 0, 1, 2}, and has all four triangles. (Lecture "modelling")
std::vector<int> greedy_strip(const HalfEdgeTable& he, int i);
