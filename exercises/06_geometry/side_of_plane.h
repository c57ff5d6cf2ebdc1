#pragma once

#include "course/mesh/shapes.h"

/// On which side of the plane the point p lies: Side::on where its distance
/// from the plane is at most `tolerance`, else Side::positive on the side that
/// the normal points to, and Side::negative on the other.
/// The distance is in the unit of the coordinates, whatever the length of the
/// normal is. Rounding may decide for points whose distance is within 1e-9 of
/// the tolerance (relative to the larger of it and the distance of p from the
/// plane's q).
/// Precondition: tolerance > 0, the normal is not 0, all numbers are finite.
/// Example: for the plane through (0, 0, 1) with normal (0, 0, 10), the point
/// (5, 5, 3) is on the positive side, (5, 5, 0) on the negative; with the
/// tolerance 0.01, (5, 5, 1.005) is on the plane.
/// (Lecture "modelling")
Side side_of_plane(const Plane& plane, Vec3 p, double tolerance);
