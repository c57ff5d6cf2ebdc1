// The figures of the lecture notes, drawn from real tables.
#pragma once

#include <map>
#include <string>

namespace course {

/// All figures: file name ("slide.svg") and SVG. Of each mesh of the zoo that
/// can be drawn; and of some walks on the slide mesh.
std::map<std::string, std::string> lecture_figures();

}  // namespace course
