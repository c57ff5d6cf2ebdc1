// The result of a check, told to the student on a terminal.
#pragma once

#include <filesystem>
#include <string>

#include "course/runner/exercises.h"
#include "course/runner/results.h"

namespace course {

/// Verdict, what the compiler said, cases; the first failed case in full: call,
/// expected, got, walk, the table with the rows of the walk marked, beside it
/// the mesh, hint. Text of the submission is shown with control characters
/// spelled out. Plain text without colours, lines of any length.
std::string explain_result(const Exercise& exercise,
                           const std::filesystem::path& file,
                           const ExerciseResult& result);

}  // namespace course
