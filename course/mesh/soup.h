// The triangle soup: triangles as triples of points, with nothing that says
// which of them meet. The simplest way to store a mesh. (Lecture "modelling")
#pragma once

#include <array>
#include <vector>

#include "course/mesh/vec3.h"

/// The corners of one triangle, counter-clockwise.
using SoupTriangle = std::array<Vec3, 3>;

/// Triangles side by side. Where two of them meet, the point stands in both.
using Soup = std::vector<SoupTriangle>;
