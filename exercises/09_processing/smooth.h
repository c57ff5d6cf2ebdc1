#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"

/// The positions of the vertices after `steps` steps of Laplacian smoothing.
/// In a step each vertex that may move goes from p to p + w (m - p), where m is
/// the mean of its neighbours: the other ends of its edges, each edge counted
/// once, all with the same weight. All vertices move at once: a step reads only
/// positions from before the step.
///
/// Vertices that stay, with exactly the numbers that they have: those with an
/// edge that lacks a face on a side (border and dangling edges), and those that
/// no half-edge leaves. They still count as neighbours of others.
/// A vertex may have several fans (hourglass): its edges are those of all fans.
/// w is used as it is, also below 0 or above 1; w = 0 leaves all as it was, w =
/// 1 puts each moving vertex on the mean. steps = 0 returns the positions.
/// The result has as many elements as `positions`.
///
/// Precondition: the table is valid, and positions has an element for each
/// vertex in it; there may be more.
/// Errors: std::invalid_argument when steps is negative.
/// Cost: linear, steps * (half-edges + vertices).
/// Example: fan6 with vertex 0 at (0, 0, 3) instead of the origin: the six
/// others are on the border, their mean is the origin, so smooth(he, p, 1, 0.5)
/// puts vertex 0 at (0, 0, 1.5), and 2 steps put it at (0, 0, 0.75).
/// (Lecture "mesh processing": denoising and smoothing)
std::vector<Vec3> smooth(const HalfEdgeTable& he,
                         std::span<const Vec3> positions, int steps, double w);
