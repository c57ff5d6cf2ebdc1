#pragma once

#include <span>
#include <stdexcept>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "exercises/09_processing/can_collapse.h"
#include "exercises/09_processing/collapse.h"

/// A triangle mesh simplified by edge collapses, the one with the smallest
/// quadric error first. Vertex v is at positions[v]; positions do not change.
///
/// The error of a plane at point p is (dot(n, p - a))^2, where a, b, c are the
/// corners of the triangle that the plane comes from, and n = cross(b - a,
/// c - a), not made a unit vector. So it is 36 times the square of the volume
/// between the triangle and p. Each vertex has a set of planes; in `he`, those
/// of its triangles.
///
/// Again and again, while the mesh has more than `faces` faces: of all pulls of
/// a vertex u into a neighbour v that are allowed, that with the least error is
/// carried out, as collapse does it. Its error is the sum of the errors at the
/// position of v of all planes of u and all planes of v; a plane that both have
/// counts twice. v has all these planes from then on, and keeps its position.
/// Of several pulls of equal error, that with the smallest u comes first; of
/// several of these, that with the smallest v. It ends earlier when no pull is
/// allowed. A pull of u into v is allowed when
///  1. can_collapse allows the edge in the mesh as it is then
///  2. u is not on the border
///  3. no triangle turns over: for each triangle at u that stays, dot(n, m) is
///     above 0, where n and m are its cross products as above, before and after
///     the corner u has moved to v.
///
/// Free: how the half-edges of the new table are numbered. Vertices and faces
/// keep their numbers.
/// Precondition: that of can_collapse, which you may call, as well as collapse:
/// in grading, they are right ones. Coordinates are such that all of this is
/// exact in double (small whole numbers, say), or nothing is nearly equal.
/// Errors: std::invalid_argument when `faces` is negative, when a vertex of the
/// table has no position, and when a face is no triangle.
/// Cost: to look at each edge before each collapse is good enough: O(n^2).
/// Example: 2 x 2 squares in the plane, each cut in two, and vertex 4 in the
/// middle. All errors are 0. simplify_quadric(he, positions, 6) pulls 4 into
/// the first of its neighbours where no triangle turns over; nothing more may
/// go, since all other vertices are on the border.
/// (Lecture "mesh processing": quadric edge collapse decimation)
HalfEdgeTable simplify_quadric(const HalfEdgeTable& he,
                               std::span<const Vec3> positions, int faces);
