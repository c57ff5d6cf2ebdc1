#pragma once

#include <vector>

#include "course/mesh/winged.h"

/// The half-edges that leave vertex v of a winged-edge mesh, each once. There
/// are none in the structure: each is given as an edge and the direction in
/// which it leaves v.
///
/// Order: that of the walk which goes to the opposite half-edge and then to its
/// next one, again and again, as in `outgoing` of chapter 1. So after an edge
/// that is stored from v comes its neighbour at v on the right. Where the list
/// begins is free: any rotation of it is right. The other way round is not.
/// Border: half-edges along a side without a face are listed like any other.
/// Isolated vertex (mesh.vertex[v] is -1): empty.
/// Bow-tie (faces that share only this vertex): those that the walk from the
/// edge mesh.vertex[v] meets before it is back.
/// Precondition: `mesh` is the winged-edge structure of some half-edge table,
/// as course/mesh/winged.h describes it, with edges numbered and directed in
/// any way; 0 <= v < mesh.vertex.size().
/// Cost: depends on the edges at v, not on the size of the mesh.
/// Example: a vertex 0 with three edges, number 5 stored from 0, 2 stored from
/// 0, and 8 stored to 0. With edge 5 as from_right of edge 2, to_left of edge 8
/// as 2, and from_right of 5 as 8: {5, true} {8, false} {2, true}, begun
/// anywhere. (Lecture "modelling", the second of its exercises)
std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v);
