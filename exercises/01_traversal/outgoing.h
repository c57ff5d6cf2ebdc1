#pragma once

#include <vector>

#include "course/halfedge/anchors.h"
#include "course/halfedge/half_edge_table.h"

/// The half-edges that leave vertex v, each once.
///
/// Order: that of the slide's walk, opp and then next, again and again.
/// Where it begins is free: any rotation of the list is right. The other way
/// round is not.
/// Border: half-edges without a face are listed like any other.
/// Isolated vertex (its anchor is -1): empty.
/// Bow-tie (faces that share only this vertex): those that the walk from the
/// anchor of v meets before it is back.
/// Precondition: the table is valid, `anchors` fits it (see Anchors; which
/// half-edge is the anchor may differ from call to call), and
/// 0 <= v < anchors.vertex.size().
/// Cost: the number of reads depends on the edges at the vertex and the faces
/// between them, not on the size of the mesh.
/// Slide mesh: outgoing(he, anchors, 2) is {3, 11, 14, 0}, begun anywhere.
/// (Lecture "half-edge", slides 166 and 173-174)
std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v);
