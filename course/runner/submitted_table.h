// Data exercises: the submission is a file and not a function.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace course {

/// Which file the running judge looks at.
void set_submitted_file(const std::string& path);

/// The rows of the submitted table, blank cells empty. A file that is no table
/// is recorded as a failure of the case, like a source that does not compile;
/// then throws WorkerFailed.
std::vector<std::vector<std::optional<int>>> submitted_table();

}  // namespace course
