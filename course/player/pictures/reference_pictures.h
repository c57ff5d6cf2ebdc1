// The pictures that are made by running references. A student's copy has no
// references, and goes without them.
#pragma once

#include <string>
#include <vector>

#include "course/player/pictures/pictures.h"

namespace course {

/// In the order of the chapters. To make one takes seconds: references are
/// compiled. Precondition of that: has_solutions().
std::vector<Picture> pictures_of_references();

// The data of each, in a file of its own.
std::string normals_picture();
std::string cubes_picture();
std::string smoothing_picture();
std::string simplification_picture();
std::string lod_picture();

}  // namespace course
