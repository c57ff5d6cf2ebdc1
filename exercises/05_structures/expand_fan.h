#pragma once

#include <vector>

#include "course/mesh/tri.h"

/// The triangles of a triangle fan.
///
/// The first three vertices make the first triangle. Each vertex after them
/// makes one more, with the vertex before it and the first vertex of all. All
/// triangles are wound like the first, which is wound as its vertices come.
/// Order: that of the fan. Free: at which of its vertices each triangle begins.
/// Degenerate triangles, where two of the three vertices are the same, are left
/// out; the others are what they would be with them.
/// Fewer than three vertices: empty.
/// Vertices may have any numbers from 0 on.
/// Cost: linear.
/// Example: {7, 0, 1, 2, 3} gives {7, 0, 1} {7, 1, 2} {7, 2, 3}, each of them
/// begun anywhere: {2, 3, 7} is right, too. (Lecture "modelling")
std::vector<Tri> expand_fan(const std::vector<int>& fan);
