#pragma once

#include <span>

#include "course/mesh/shapes.h"

/// The area of a polygon in the plane, given by its corners in order: positive
/// when they go round counter-clockwise (the inside to the left of each side,
/// as the lecture has it), negative when they go round clockwise. 0 for fewer
/// than three corners. The last corner is joined to the first; the first is not
/// repeated at the end.
/// The polygon may be of any shape, so long as its sides do not cross.
/// Where it lies does not matter: the error is at most 1e-9 times the square of
/// the polygon's diameter, even a million diameters away from the origin.
/// Cost: linear.
/// Example: (0, 0), (4, 0), (4, 3) has the area 6, and (0, 0), (4, 3), (4, 0)
/// has -6.
/// (Lecture "modelling")
double signed_area(std::span<const Vec2> polygon);
