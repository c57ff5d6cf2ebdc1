// The page of recorded walks.
#pragma once

#include <string>

#include "course/player/recording.h"

namespace course {

/// One HTML file that needs nothing else. Throws SystemError when a part of it
/// cannot be read.
std::string walk_page(const Recording& recording);

}  // namespace course
