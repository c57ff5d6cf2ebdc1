#pragma once

#include <span>
#include <stdexcept>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "exercises/09_processing/can_collapse.h"
#include "exercises/09_processing/collapse.h"

/// The mesh simplified by edge collapses, the shortest edge first. Vertex v is
/// at positions[v]; positions do not change, so that vertices and faces of the
/// result have the numbers that they have in `he`.
///
/// Again and again, while the mesh has more than `faces` faces: among the edges
/// that can_collapse allows in the mesh as it is then, the shortest one is
/// collapsed, as collapse does it. It ends earlier when none is allowed.
///  - Which edge: that with the smallest dot(d, d), d the difference of its
///    ends. Of several with equal ones, that whose smaller vertex number is the
///    smallest; of several of these, that whose larger number is.
///  - Which end stays: that on the border, if just one is on the border; else
///    the one with the smaller number.
/// A collapse on a closed triangle mesh takes away two faces, so that there may
/// be one fewer than asked for.
///
/// Free: how the half-edges of the new table are numbered.
/// Precondition: that of can_collapse, which you may call, as well as collapse:
/// in grading, they are right ones. Faces may have any number of sides; the
/// numbers of faces may have gaps. Coordinates are such that dot(d, d) is
/// exact, or no two edges are nearly of the same length.
/// Errors: std::invalid_argument when `faces` is negative, or a vertex of the
/// table has no position.
/// Cost: to look at each edge before each collapse is good enough: O(n^2).
/// Slide mesh, with its positions: simplify(he, positions, 2) pulls 4 into 1
/// (2-5 is as short, but may not be collapsed), then 3 into 2 (3-5 is as long
/// as 2-3): F0 = (0,2,1) and F1 = (1,2,5) are left.
/// (Lecture "mesh processing": simplification by local operations)
HalfEdgeTable simplify(const HalfEdgeTable& he, std::span<const Vec3> positions,
                       int faces);
