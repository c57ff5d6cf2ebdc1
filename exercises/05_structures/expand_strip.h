#pragma once

#include <vector>

#include "course/mesh/tri.h"

/// The triangles of a triangle strip.
///
/// The first three vertices make the first triangle. Each vertex after them
/// makes one more, with the two vertices before it.
/// Winding: triangle 0 is wound as its vertices come in the strip, triangle 1
/// the other way round, and so on in turn, by the place in the strip: so
/// neighbours agree, and the strip has one front.
/// Order: that of the strip. Free: at which of its vertices each triangle
/// begins.
/// Degenerate triangles, where two of the three vertices are the same, are left
/// out, but they count: those after them are wound as if they were there.
/// Fewer than three vertices: empty.
/// Vertices may have any numbers from 0 on.
/// Cost: linear.
/// Example: {0, 1, 2, 3, 4} gives {0, 1, 2} {2, 1, 3} {2, 3, 4}, each of them
/// begun anywhere; {0, 1, 2, 2, 3, 4} gives {0, 1, 2} and {2, 4, 3}, the
/// triangles 0 and 3. (Lecture "modelling")
std::vector<Tri> expand_strip(const std::vector<int>& strip);
