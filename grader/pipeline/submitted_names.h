// Names of files and folders in a submission that are not those of exercises.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// Folders that tools leave behind and that hold no submission, and files that
/// lie hidden.
bool is_left_behind(std::string_view name);

/// The file name that was meant by one that is not among them, if it is near.
std::optional<std::string> meant_by(std::string_view name,
                                    const std::vector<std::string>& file_names);

}  // namespace grader
