#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The faces at the vertex that half-edge i leaves, each once.
///
/// Order: as the slide's walk round the vertex meets them (opp and then next,
/// again and again). Where the walk begins is free; so any rotation of the list
/// is right, and the other way round is not. A face that is met again is left
/// out the second time.
/// Border: a gap is not a face: -1 is never in the list. A vertex with loose
/// edges only has no faces: empty.
/// Bow-tie (faces that share only this vertex): those that the walk from i
/// meets before it is back.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: the number of reads depends on the edges at the vertex and the faces
/// between them, not on the size of the mesh.
/// Slide mesh: vertex_faces(he, 3) is {0, 1, 2}, begun anywhere.
/// (Lecture "half-edge", slides 175-176)
std::vector<int> vertex_faces(const HalfEdgeTable& he, int i);
