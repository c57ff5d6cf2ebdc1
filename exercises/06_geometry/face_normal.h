#pragma once

#include <optional>

#include "course/mesh/vec3.h"
#include "exercises/06_geometry/area_vector.h"

/// The normal of the triangle a, b, c: of unit length, orthogonal to it, on the
/// side from which a, b, c run counter-clockwise.
/// std::nullopt when the triangle is degenerate.
///
/// Fixed: it is degenerate when twice its area is at most 1e-12 times the
/// square of its longest side. That holds for corners that coincide or lie on
/// one line, also up to rounding, and it does not depend on the unit of length:
/// a tiny triangle has a normal as well as a huge one.
/// Precondition: all coordinates are finite; the sides are shorter than 1e60,
/// and longer than 1e-60 or 0.
/// Cost: constant.
/// Builds on: area_vector, which you may call.
/// Example: (0,0,0), (3,0,0), (0,4,0) has the normal (0, 0, 1).
/// (Lecture "mesh processing", the normal of a triangle; lecture "modelling",
/// normals)
std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c);
