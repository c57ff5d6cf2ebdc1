// A mesh as an SVG drawing, in the notation of the lecture: an arrow for each
// half-edge, on its own side of the edge, with its number.
#pragma once

#include <string_view>

#include "course/report/html.h"
#include "course/report/walk.h"
#include "course/runner/results.h"

namespace course {

/// How the parts of a drawing look, for the style of a page that sets the
/// colours --ink and --amber.
inline constexpr std::string_view mesh_style =
    R"css(.mesh .face { fill: #eef2f6; }
.mesh .face-label { font-size: 12px; fill: #7a8594; font-weight: 600; }
.mesh .behind { fill: #b3bcc7; }
.mesh .edge { stroke: #c3cad3; stroke-width: 2; }
.mesh .he { stroke: #566273; stroke-width: 1.5; }
.mesh .head { fill: #566273; stroke: none; }
.mesh line.border { stroke-dasharray: 5 3; }
.mesh .walked { stroke: var(--amber); stroke-width: 3.5; }
.mesh .head.walked { fill: var(--amber); stroke: none; }
.mesh .number { fill: #fff; stroke: #a8b1bd; stroke-width: 1; }
.mesh .number.walked { fill: var(--amber); stroke: var(--amber);
                       stroke-width: 1; }
.mesh .number-text { font-size: 11px; fill: var(--ink); font-weight: 600; }
.mesh .number-text.walked { fill: #fff; stroke: none; }
.mesh .step { fill: var(--ink); }
.mesh .step-text { font-size: 9.5px; fill: #fff; font-weight: 600; }
.mesh .vertex { fill: #fff; stroke: var(--ink); stroke-width: 1.5; }
.mesh .vertex-text { font-size: 10px; font-weight: 650; fill: var(--ink); }
)css";

/// Drawings of more half-edges than this cannot be read.
inline constexpr std::size_t most_drawn_half_edges = 60;

/// The drawing, with the half-edges of the walk set off and numbered; nothing
/// when the picture has no rows or too many. Positions in space are projected;
/// without usable ones the vertices lie on a circle. The table may be broken
/// in any way: what has no place is left out. Where `opp` is -1, the tip is the
/// start of `next`: so the faces of a mesh that has no table can be drawn.
Html mesh_drawing(const MeshPicture& mesh, const Walk& walk);

}  // namespace course
