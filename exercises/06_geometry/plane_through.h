#pragma once

#include <optional>

#include "course/mesh/shapes.h"

/// The plane through three points, as a point of it and its normal;
/// std::nullopt where the three do not fix one, because they lie on a line.
///
/// Fixed: the normal u is of unit length, and points to the side from which p,
/// q, r are seen counter-clockwise. The three count as lying on a line when
/// twice the area of their triangle is at most 1e-12 of its longest side
/// squared.
/// Free: which of p, q and r is the point q of the plane; it is one of them,
/// unchanged.
/// Precondition: the coordinates are finite.
/// Example: plane_through({1, 0, 5}, {0, 1, 5}, {0, 0, 5}) has the normal
/// (0, 0, 1) and goes through one of the points, such as (1, 0, 5).
/// (Lecture "modelling")
std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r);
