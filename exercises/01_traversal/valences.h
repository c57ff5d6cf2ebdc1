#pragma once

#include <map>

#include "course/halfedge/half_edge_table.h"

/// How many vertices have which valence: result[k] of the vertices
/// 0..vertex_count-1 have k edges.
///
/// The valence of a vertex counts all its edges: border and loose edges too,
/// and at a bow-tie those of all its fans. A vertex that no half-edge leaves
/// has valence 0.
/// Only values that occur are keys: no key has the count 0.
/// Empty when vertex_count is 0.
/// Precondition: the table is valid, every vi is below vertex_count.
/// Cost: a few reads for each half-edge of the table.
/// Slide mesh: valences(he, 6) is {2: 3, 3: 2, 4: 1}, three vertices of
/// valence 2, two of 3, one of 4. (Lecture "half-edge", slides 166 and 173-174)
std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count);
