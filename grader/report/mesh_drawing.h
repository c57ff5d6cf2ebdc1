// A mesh as an SVG drawing, in the notation of the lecture: an arrow for each
// half-edge, on its own side of the edge, with its number.
#pragma once

#include "course/report/walk.h"
#include "course/runner/results.h"
#include "grader/report/html.h"

namespace grader {

/// Drawings of more half-edges than this cannot be read.
inline constexpr std::size_t most_drawn_half_edges = 60;

/// The drawing, with the half-edges of the walk set off and numbered; nothing
/// when the picture has no rows or too many. Positions in space are projected;
/// without usable ones the vertices lie on a circle. The table may be broken
/// in any way: what has no place is left out.
Html mesh_drawing(const course::MeshPicture& mesh, const course::Walk& walk);

}  // namespace grader
