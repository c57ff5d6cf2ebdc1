#pragma once

#include <stdexcept>

#include "course/mesh/mat3.h"
#include "course/mesh/vec3.h"

/// The normal after the surface was transformed by m: a point or a tangent p
/// becomes m * p, the normal n becomes the INVERSE TRANSPOSE of m, times n, at
/// unit length. So it is again orthogonal to the surface.
///
/// Fixed: the sign is that of the inverse transpose. A mirror (negative
/// determinant) turns the winding of the faces round, but the normal stays on
/// its side of the surface: it still makes an angle below 90 degrees with m *
/// n. Matrices are row major: m.rows[0] is the first row, and vectors are
/// columns. n may have any length but 0; multiples of m by a positive factor
/// have the same result, however small or large. Errors: std::domain_error when
/// m is singular: when the absolute value of its determinant is at most 1e-12
/// times the product of the lengths of its rows. Precondition: all numbers are
/// finite; those of m are 0 or between 1e-60 and 1e60 in absolute value. Cost:
/// constant. Example: scaled by two in x, m = ((2,0,0), (0,1,0), (0,0,1)), the
/// normal (1, 1, 0) becomes (1, 2, 0) / sqrt(5), not (2, 1, 0) / sqrt(5).
/// (Lecture "modelling", normals and transformations)
Vec3 transform_normal(const Mat3& m, Vec3 n);
