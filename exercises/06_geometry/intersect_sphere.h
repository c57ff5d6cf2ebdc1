#pragma once

#include <vector>

#include "course/mesh/shapes.h"

/// The parameters t of the points q + t * u in which a line, a ray or a segment
/// meets the surface of the sphere, in ascending order: none, one or two. Only
/// those within the extent count (0 <= t for a ray, 0 <= t <= 1 for a segment);
/// the ends belong to it.
///
/// Which points the whole line has is decided by d, its distance from the
/// center: it touches the sphere when d differs from the radius by at most
/// 1e-9 * radius, and has then one parameter, that of its point nearest to the
/// center. With d larger it has none, with d smaller two.
/// The direction has any length; t counts in lengths of u, as in point_at.
/// Precondition: u is not 0, radius > 0, all numbers are finite. Where an end
/// of a ray or a segment is within 1e-9 (in t) of the surface, rounding may
/// decide, unless the line is along an axis and goes through the center, and
/// all numbers are whole.
/// Example: for the unit sphere round the origin, the line from (-3, 0, 0) with
/// u = (2, 0, 0) has {1, 2}; the ray from the origin with that u has {0.5}; the
/// line from (-3, 1, 0) with that u touches: {1.5}.
/// (Lecture "modelling")
std::vector<double> intersect_sphere(const Line& line, const Sphere& sphere);
