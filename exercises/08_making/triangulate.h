#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <vector>

#include "course/mesh/vec3.h"

/// A polygon cut into triangles, convex or not. Each triangle is three corners
/// of the polygon by their number: polygon[0] is corner 0.
///
/// Fixed: a polygon of n corners gives n - 2 triangles, that together cover it
/// and nothing else, without overlapping. Each is wound as the polygon is, and
/// has an area: three corners in line are no triangle.
/// Free: everything else. Any such cut is right, the triangles may come in any
/// order, and each may begin at any of its corners.
/// Precondition: the polygon lies in a plane, which may be any, and is simple:
/// its sides meet only at the corners that they share, and no two corners are
/// in the same place. It may be of any size, run either way round, and begin
/// anywhere. Three corners may lie in line, neighbours or not, but only where
/// the plane is x = c, y = c or z = c and all coordinates are whole numbers,
/// below 1000: cross products of differences are then exact.
/// Errors: std::invalid_argument when there are fewer than three corners.
/// Cost: of the order of n^3 at most, as ear clipping has it.
/// Example: (0,0,0), (3,0,0), (1,1,0), (0,3,0), which is not convex at corner
/// 2, gives (0,1,2), (0,2,3). The other diagonal would be wrong.
/// (Lecture "modelling")
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon);
