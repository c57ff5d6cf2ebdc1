// submission_metadata.yml of a Gradescope export: who handed in what, and when.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "grader/gradebook/member.h"

namespace grader {

inline constexpr std::string_view gradescope_metadata_file =
    "submission_metadata.yml";
inline constexpr std::size_t largest_gradescope_metadata = 16u << 20;

struct GradescopeSubmission {
    std::string folder;  ///< "submission_123"
    std::vector<Member> submitters;
    std::string created_at;  ///< as it stands there
};

/// The file cannot be read; the message says why.
struct MetadataError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads the file's bytes, which may be hostile, in a child process without
/// rights. What is not as expected is left empty. Precondition: no other thread
/// runs. Throws MetadataError, also where this grader was built without
/// yaml-cpp, and course::SystemError.
std::vector<GradescopeSubmission> read_gradescope_metadata(
    const std::string& bytes);

}  // namespace grader
