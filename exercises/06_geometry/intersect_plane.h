#pragma once

#include <optional>

#include "course/mesh/shapes.h"

/// The parameter t of the point q + t * u in which a line, a ray or a segment
/// meets the plane; std::nullopt where it does not, or where t is outside of
/// its extent (below 0 for a ray, below 0 or above 1 for a segment). The ends
/// belong to it.
///
/// A line that is parallel to the plane has no such point, even if it lies in
/// the plane. It counts as parallel when the cosine of the angle between its
/// direction and the normal of the plane is at most 1e-12 (either sign).
/// Directions and normals have any length; t counts in lengths of the line's u,
/// as in point_at.
/// Precondition: u of the line and u of the plane are not 0, all numbers are
/// finite. Where an end of a ray or a segment is within 1e-9 of the plane
/// (in t), rounding may decide, unless line and plane are along the axes and
/// all numbers are whole.
/// Example: the segment from (0, 0, 4) with u = (0, 0, -8) meets the plane
/// through (1, 1, 1) with normal (0, 0, 2) at t = 0.375, the point (0, 0, 1).
/// (Lecture "modelling")
std::optional<double> intersect_plane(const Line& line, const Plane& plane);
