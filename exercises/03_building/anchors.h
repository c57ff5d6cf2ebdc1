#pragma once

#include "course/halfedge/anchors.h"
#include "course/halfedge/half_edge_table.h"

/// One half-edge for each vertex, one that leaves it, and one for each face,
/// one that runs along it: where a walk round the one or the other may begin.
///
/// The result has `vertex_count` elements in `vertex` and `face_count` in
/// `face`; -1 stands where no half-edge leaves the vertex, or runs along the
/// face.
/// Free: which of its half-edges a vertex or a face gets.
/// Border cases: half-edges on the border, and those of loose edges, leave
/// vertices as all others do; they are good for a vertex, and run along no
/// face. An empty table has none: all elements are -1.
/// Precondition: the table is valid; each vi is below vertex_count, each fi
/// below face_count; neither count is negative.
/// Cost: a fixed number of reads for each half-edge, however many vertices and
/// faces there are.
/// Slide mesh: anchors(he, 6, 3) may have {1, 2, 0, 9, 7, 8} for the vertices
/// and {1, 4, 8} for the faces. (Lecture "half-edge", slide 166)
Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count);
