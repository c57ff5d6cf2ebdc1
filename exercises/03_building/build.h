#pragma once

#include <stdexcept>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

/// The half-edge table of a mesh, with a border or without: two half-edges for
/// each edge. Where an edge has a face on one side only, the half-edge on the
/// other side lies on the border, with fi == -1.
///
/// Fixed: vertices and faces have the numbers of the mesh; `next` goes round
/// each face in the order of its corners; on the border, it leads from a
/// half-edge that arrives at a vertex to one without a face that leaves this
/// vertex, and no two lead to the same one. A loose edge of the mesh has two
/// half-edges, both with fi == -1.
/// Free: how the half-edges are numbered; and, where several of them without a
/// face arrive at one vertex (bow-ties, loose edges), which of those that leave
/// it follows which.
/// Border cases: vertices that no face or loose edge uses have no half-edge; a
/// mesh without faces and loose edges has an empty table.
/// Errors: std::invalid_argument when a face has less than three corners, or
/// the same vertex at two of them; when a corner, or an end of a loose edge, is
/// no vertex of the mesh; when two sides of faces run from the same vertex to
/// the same vertex, as it is with three faces at one edge; when a loose edge
/// ends where it begins, or has the ends of another loose edge or of a side.
/// Cost: n log n for n corners, as long as few edges meet at a vertex.
/// Slide mesh: 16 half-edges, of which 6 on the border, in one loop. One
/// triangle: 6 half-edges, of which 3. (Lecture "half-edge", slide 170)
HalfEdgeTable build(const IndexedMesh& mesh);
