// The archive from which Gradescope makes an autograder.
#pragma once

#include <filesystem>
#include <string>

namespace grader {

/// The bytes of a zip with setup.sh and run_autograder (grader/gradescope/),
/// the assignment file as assignment.toml, and in tree/ this tree as it is,
/// without builds, sample class and what Git keeps. Throws course::SystemError.
std::string gradescope_bundle(const std::filesystem::path& assignment);

}  // namespace grader
