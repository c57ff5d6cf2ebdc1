#pragma once

#include "course/halfedge/edge_kind.h"
#include "course/halfedge/half_edge_table.h"

/// Kind of the edge that half-edge i is one side of: interior with a face on
/// both sides (the same face twice counts as two), border with a face on one
/// side only, dangling with none.
///
/// Border: i may be either half-edge of the edge; both get the same answer.
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads, however large the mesh is.
/// Slide mesh: edge_kind(he, 3) == EdgeKind::interior.
/// (Lecture "half-edge", slides 156-157 and 181)
EdgeKind edge_kind(const HalfEdgeTable& he, int i);
