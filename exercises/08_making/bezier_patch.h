#pragma once

#include <stdexcept>

#include "course/mesh/grids.h"
#include "exercises/08_making/bezier.h"

/// The point of a Bezier patch at the parameters (u, v): a surface from a grid
/// of control points. Each row of the grid (those with the same j) is the
/// control polygon of a curve in u; the points of these curves at u are the
/// control polygon of a curve in v, and its point at v is the result. Columns
/// first, then the row, gives the same point.
///
/// This builds on `bezier`, and may call it; when you are graded, that is the
/// right one.
/// The patch passes through the four corners of the grid: at (0, 0) it is at
/// points[0], at (1, 0) at points[nu - 1]. Its borders are the curves of the
/// outer rows and columns. A grid of one row is a curve in u.
/// Precondition: 0 <= u <= 1 and 0 <= v <= 1; coordinates are finite.
/// Errors: std::invalid_argument when nu or nv is below 1, or there are not
/// nu * nv points.
/// Cost: of the order of nu * nv * (nu + nv).
/// Example: nu = nv = 2, points (0,0,0), (2,0,0), (0,2,0), (2,2,4): the patch
/// at (u, v) is (2u, 2v, 4uv), so at (0.5, 0.25) it is (1, 0.5, 0.5).
/// (Lecture "modelling")
Vec3 bezier_patch(const ControlGrid& grid, double u, double v);
