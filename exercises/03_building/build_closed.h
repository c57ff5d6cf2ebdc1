#pragma once

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

/// The half-edge table of a closed mesh: one half-edge for each side of each
/// face.
///
/// Fixed: vertices and faces have the numbers of the mesh; `next` goes round
/// each face in the order of its corners; `opp` is the half-edge that runs
/// between the same two vertices the other way.
/// Free: how the half-edges are numbered.
/// Border cases: vertices that no face uses have no half-edge. Two faces may
/// share several edges, or all of them; parts of the mesh may be apart, or meet
/// in a single vertex. A mesh without faces has an empty table.
/// Precondition: each face has at least three corners, at different vertices of
/// the mesh; each side, from a to b, is there once, and one from b to a as
/// well; there are no loose edges.
/// Cost: n log n for n corners, as long as few edges meet at a vertex.
/// A tetrahedron, {0,1,2} {0,3,1} {1,3,2} {2,3,0}, has twelve rows; one right
/// table begins {0, 0, 1, 5}, {1, 0, 2, 8}, {2, 0, 0, 11}, {0, 1, 4, 10}.
/// (Lecture "half-edge", slides 166 and 170)
HalfEdgeTable build_closed(const IndexedMesh& mesh);
