#pragma once

#include "course/halfedge/half_edge_table.h"

/// Whether the vertex that half-edge i leaves lies on a border: whether some
/// half-edge at that vertex has no face. A loose edge has none on either side,
/// so both of its ends lie on a border.
///
/// Any half-edge that leaves the vertex may be given; all get the same answer.
/// (Where several fans of faces meet in one vertex, it is asked of the fan that
/// the walk round the vertex from i goes through.)
/// Precondition: 0 <= i < he.size(), the table is valid.
/// Cost: a fixed number of reads for each corner of the faces at the vertex,
/// however large the mesh is.
/// Slide mesh: is_border_vertex(he, 4), for vertex 1, is true, as at each of
/// its six vertices. (Lecture "half-edge", slides 156 and 173-176)
bool is_border_vertex(const HalfEdgeTable& he, int i);
