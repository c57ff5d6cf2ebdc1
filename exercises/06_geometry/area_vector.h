#pragma once

#include "course/mesh/vec3.h"

/// The area vector of the triangle a, b, c. It is orthogonal to the triangle,
/// points to the side from which a, b, c run counter-clockwise, and its length
/// is TWICE the area of the triangle.
///
/// Free: from which of its corners it is computed; a, b, c and b, c, a are the
/// same triangle. a, c, b is the other side of it.
/// Degenerate: the zero vector, up to rounding, when two corners coincide or
/// all three lie on one line.
/// Precision: that of double, relative to the size of the triangle and not to
/// its distance from the origin. A small triangle far away must be as exact as
/// one at the origin.
/// Precondition: all coordinates are finite.
/// Cost: constant.
/// Example: (0,0,0), (3,0,0), (0,4,0) has the area 6 and the area vector
/// (0, 0, 12). (Lecture "mesh processing", the normal of a triangle; lecture
/// "modelling", normals)
Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c);
