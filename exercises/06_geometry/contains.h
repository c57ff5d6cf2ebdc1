#pragma once

#include <span>

#include "course/mesh/shapes.h"

/// Whether the point p is inside the polygon, given by its corners in order,
/// clockwise or counter-clockwise. The last corner is joined to the first; the
/// first is not repeated at the end. Nothing is inside a polygon of fewer than
/// three corners.
/// Precondition: the polygon is simple: its sides meet only in corners, and
/// only those that follow each other. It need not be convex; sides may lie in
/// line. The point is not on the border (for one that is nearer to it than 1e-9
/// times the polygon's diameter, either answer is right), but it may well be at
/// the same height as corners and sides, or straight above them.
/// Cost: linear.
/// Example: in the L with corners (0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0,
/// 2) the points (0.5, 1) and (2, 0.5) are inside, (2, 1.5) and (4, 1) are not.
/// (Lecture "modelling")
bool contains(std::span<const Vec2> polygon, Vec2 p);
