#pragma once

#include "course/halfedge/half_edge_table.h"

/// How many connected components the mesh has: as a graph of vertices and
/// edges. Two vertices are in one component when a chain of edges joins them,
/// whatever faces lie beside these edges.
///
/// So parts that meet only in one vertex (a bow-tie) are one component, even if
/// `next` and `opp` never lead from the one to the other; and a loose edge
/// joins what is at its two ends. Border cases: an isolated vertex, which no
/// half-edge leaves, does not count. A loose edge that hangs on nothing is a
/// component of its own. An empty table has 0 components. Vertex numbers may
/// have gaps, and may be larger than the table. Precondition: the table is
/// valid. Cost: a fixed number of reads for each half-edge, and about linear in
/// time (n log n will do), however the rows are numbered. Slide mesh:
/// components(he) == 1. (Lecture "mesh memory formats", page 4; lecture
/// "modelling": S in Euler's equation)
int components(const HalfEdgeTable& he);
