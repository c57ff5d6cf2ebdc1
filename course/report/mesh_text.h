// A small flat mesh drawn with characters, for a terminal.
#pragma once

#include <string>

#include "course/report/walk.h"
#include "course/runner/results.h"

namespace course {

/// The drawing in at most so many columns and lines: edges in braille dots,
/// V0 at a vertex, F0 in a face, and the number of each half-edge on its own
/// side of the edge, with > before those of the walk. Empty where it would not
/// help: a mesh in space, one with more half-edges than can be told apart in
/// that room, one without positions.
std::string mesh_text(const MeshPicture& mesh, const Walk& walk, int columns,
                      int lines);

}  // namespace course
