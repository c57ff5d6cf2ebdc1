// Paths: their parts, and which are refused when an archive has them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grader {

/// Of a path in an archive, in bytes.
inline constexpr std::size_t longest_path = 1024;

/// The path without what only says "here" and "folder": a "./" before it, as
/// tar writes it, and one "/" behind it. "" is the archive's own folder.
std::string plain_path(std::string_view name);

/// "week1" and "prev.cpp" of "week1/prev.cpp"; "" and "prev.cpp" of "prev.cpp".
std::string_view folder_of(std::string_view path);
std::string_view name_in(std::string_view path);

/// Why an entry of that path is refused: it leads elsewhere, or would on
/// another system, or is no name. Empty when it is not.
std::string why_refused(std::string_view path);

}  // namespace grader
