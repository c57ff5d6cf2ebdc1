// A triangle by the numbers of its vertices.
#pragma once

#include <array>

/// The three vertices, counter-clockwise: {0, 1, 2} and {1, 2, 0} are the same
/// triangle, {0, 2, 1} is the other side of it.
using Tri = std::array<int, 3>;
