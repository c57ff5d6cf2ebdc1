#pragma once

#include "course/halfedge/half_edge_table.h"

/// Whether the mesh is closed, like a ball, in all its components: every edge
/// has a face on both sides.
///
/// Border cases: one face on both sides of an edge is a face on both sides. A
/// loose edge has a side without a face, so a mesh with one is not closed, nor
/// is a mesh of loose edges only. An empty table has no edge that could be
/// open: true.
/// Precondition: the table is valid.
/// Cost: a fixed number of reads for each half-edge, 8 at most.
/// Slide mesh: is_closed(he) == false, because of half-edge 0 and five others.
/// A tetrahedron: true. (Lecture "modelling", notes on orientation; lecture
/// "mesh memory formats", page 4)
bool is_closed(const HalfEdgeTable& he);
