#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

/// The face list of the table: for each face its vertices in the order of
/// `next`, that is, counter-clockwise as the mesh was given.
///
/// Fixed: element f of the result is the face with number f.
/// Free: with which of its corners a face begins.
/// Border cases: the border is no face, and loose edges are none; an empty
/// table, or one of loose edges only, has no faces. A face that comes to a
/// vertex with two of its corners names it twice.
/// Precondition: the table is valid, and its faces have the numbers 0, 1, 2 ...
/// with no gap.
/// Cost: a fixed number of reads for each half-edge.
/// Slide mesh: {{0, 2, 1}, {1, 2, 5, 4}, {2, 3, 5}}.
/// (Lecture "half-edge", slide 170)
std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he);
