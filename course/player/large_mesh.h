// The page of a mesh that is too large for a drawing with all its arrows: in
// 3D, turned by hand, with arrows only near the current half-edge.
//
// It is drawn on a 2D canvas by a depth buffer of our own (page/raster.js), not
// by WebGL. Measured side by side on a machine without a graphics card (2 cores
// that others used as well; Chromium 156, which then does WebGL in software),
// a torus at 1280 x 720 that turns: milliseconds of processor a frame, all
// processes of the browser together, and what the page carries for it:
//
//                             10 000 faces   100 000   1 000 000   script
//     three.js 0.187 (WebGL)             41        79         426   527 kB
//     WebGL2 by hand                     70       120         498     2 kB
//     canvas, painter's order            28       160        1424     2 kB
//     canvas, depth buffer               31        31          80    11 kB
//
// With a graphics card WebGL would be faster, but there this is fast enough; it
// needs no library and no fallback. It also keeps the face of each pixel, which
// makes picking exact at no cost, and draws edges only where they are seen.
#pragma once

#include <string>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// One HTML file with the whole mesh: 16 bits a coordinate, on the longest side
/// of its box; and its faces. The page makes of them the table that `build`
/// makes and compares a sum of it, so that its numbers are those of the walks.
/// `title` names the mesh. `recording` is the JSON of recorded walks (see
/// recording.h), its `mesh` left out; "null": the page is for walks by hand.
/// A face with more than three sides is drawn as a fan from its first corner.
/// Throws BuildError when the mesh has no table, std::invalid_argument when a
/// coordinate is not finite, SystemError when a part of the page cannot be
/// read. Linear.
std::string large_mesh_page(const std::string& title, const IndexedMesh& mesh,
                            const std::string& recording = "null");

}  // namespace course
