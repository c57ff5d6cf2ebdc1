#pragma once

#include <optional>
#include <span>
#include <stdexcept>

#include "course/mesh/vec3.h"
#include "exercises/06_geometry/area_vector.h"

/// How far the corners of a polygon are from lying in one plane: the greatest
/// distance of a corner from the mean plane, in the units of the positions.
///
/// The mean plane goes through the mean of the corners (their sum divided by
/// their number), and its normal is the area vector of the polygon,
///     area_vector(p0, p1, p2) + area_vector(p0, p2, p3) + ...
/// So the result does not depend on the corner at which the polygon begins, nor
/// on its winding. For a quad it is half the distance between the lines through
/// its two diagonals. For a triangle it is 0, up to rounding.
/// std::nullopt where the area vector is not longer than 1e-12 times the sum of
/// the squared lengths of all sides, the one from the last corner to the first
/// included: then the polygon has no normal.
/// Errors: std::invalid_argument when there are fewer than three corners.
/// Precision: relative to the size of the polygon and not to its distance from
/// the origin.
/// Precondition: all coordinates are finite.
/// Cost: linear in the number of corners.
/// Builds on: area_vector, which you may call.
/// Example: (0,0,0), (1,0,1), (1,1,0), (0,1,1), corners of a cube: its mean
/// plane is z = 0.5, the result 0.5. (Lecture "modelling": quad meshes need the
/// constraint that each quad is planar)
std::optional<double> planarity_error(std::span<const Vec3> corners);
