#pragma once

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/winged.h"

/// The winged-edge structure of the mesh that the half-edge table describes:
/// one edge for each two opposite half-edges, with all eight references as
/// course/mesh/winged.h says, and one edge for each vertex and each face.
///
/// Vertices and faces keep their numbers. `vertex` is as long as the largest
/// vertex number in the table plus one, `face` as long as the largest face
/// number plus one; -1 stands where a number below the largest is not in use.
/// Free: how edges are numbered, in which direction each is stored, and which
/// edge stands in vertex[v] and in face[f].
/// Border: the neighbours on a side without a face are those that the border
/// half-edge has: the edge of its `next`, and that of the half-edge whose
/// `next` it is. So it is at bow-ties and loose edges, too.
/// An empty table gives an empty structure.
/// Precondition: the table is valid.
/// Cost: a few reads for each half-edge, however many sides a face has and
/// however many edges meet at a vertex.
/// Slide mesh: the edge of half-edges 4 and 3, stored from 1 to 2, has F1 on
/// its left and F0 on its right, from_left is the edge between 4 and 1,
/// to_left that between 2 and 5, from_right that between 1 and 0, to_right
/// that between 0 and 2. (Lecture "modelling")
WingedMesh winged(const HalfEdgeTable& he);
