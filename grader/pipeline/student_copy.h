// The student's copy of this tree: made, and tried as a student would use it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "grader/pipeline/assignment.h"

namespace grader {

/// What a copy for the assignment has, in the order of the tree: its exercises
/// and those that they build on; without an assignment all there are.
std::vector<course::Exercise> released_exercises(
    const std::optional<Assignment>& assignment);

/// Makes the copy in a new folder: this tree with these exercises, without
/// solutions, grader and sample class, with an original of each file that
/// students edit. Where exercises are missing, so are the framework's own
/// tests, which use them, and the lines about them in the chapters' tables;
/// contracts that course/ includes stay. Throws course::SystemError,
/// std::filesystem::filesystem_error.
void make_student_copy(const std::filesystem::path& to,
                       const std::vector<course::Exercise>& exercises);

/// Builds a copy of the copy elsewhere and tries each exercise with its own
/// `lab`: the reference is accepted, the skeleton compiles and is not. What is
/// not so, as sentences; empty when all is well. Minutes. `say` is told what
/// comes next. Throws course::SystemError.
std::vector<std::string> complaints_about_copy(
    const std::filesystem::path& copy,
    const std::vector<course::Exercise>& exercises,
    const std::function<void(const std::string&)>& say);

}  // namespace grader
