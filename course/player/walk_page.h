// The page of recorded walks.
#pragma once

#include <string>

#include "course/player/recording.h"

namespace course {

/// Above that many faces a drawing of the whole mesh with all its arrows shows
/// nothing: the page has the mesh in 3D, and arrows near to where a walk is.
inline constexpr int most_drawn_faces = 200;

/// One HTML file that needs nothing else. Throws SystemError when a part of it
/// cannot be read.
std::string walk_page(const Recording& recording);

}  // namespace course
