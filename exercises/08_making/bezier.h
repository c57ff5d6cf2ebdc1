#pragma once

#include <span>
#include <stdexcept>

#include "course/mesh/vec3.h"

/// The point of a Bezier curve at the parameter t, by the algorithm of de
/// Casteljau: each pair of neighbouring points is replaced by the point that
/// divides it in the ratio t to 1 - t; this again and again, until one is left.
///
/// The curve begins at the first control point (t = 0) and ends at the last one
/// (t = 1). It is drawn towards the others, and in general does not pass
/// through them. n control points make a curve of degree n - 1: one is a curve
/// that stays where it is, two are a segment.
/// Precondition: 0 <= t <= 1; coordinates are finite.
/// Errors: std::invalid_argument when there are no control points.
/// Cost: of the order of n^2. The result is exact but for rounding with a
/// hundred control points, too.
/// Example: the points (0,0,0), (2,0,0), (2,2,0) have at t = 0.5 the point
/// (1.5,0.5,0): first (1,0,0) and (2,1,0), then the middle of these.
/// (Lecture "modelling")
Vec3 bezier(std::span<const Vec3> points, double t);
