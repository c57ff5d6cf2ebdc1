#pragma once

#include <optional>

#include "course/mesh/shapes.h"

/// The point q + t * u of a line, a ray or a segment; std::nullopt where t is
/// outside of its extent: below 0 for a ray, below 0 or above 1 for a segment.
/// The ends belong to it, and no tolerance is added. The direction u is taken
/// as it is, whatever its length.
/// Precondition: t and the coordinates are finite.
/// Example: on the segment from (1, 0, 0) with u = (0, 4, 0), t = 0.5 is
/// (1, 2, 0), and t = 1.5 is no point; on the ray it is (1, 6, 0).
/// (Lecture "modelling")
std::optional<Vec3> point_at(const Line& line, double t);
