// What the commands have in common that look into the folder of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/assignment.h"

namespace grader {

/// Throws CannotBegin when that is not the folder of an earlier run.
void expect_gradebook(const std::filesystem::path& out);

/// The gradebook of that folder. Throws CannotBegin and GradebookError.
Gradebook gradebook_in(const std::filesystem::path& out,
                       Gradebook::Access access = Gradebook::Access::read);

/// What the newest run graded, with weight 1 each.
Assignment unweighted_assignment(const Gradebook& gradebook);

/// The student of that id or folder name. Throws CannotBegin, which names the
/// nearest right one.
const Student& student_named(const Run& run, const std::string& name);

/// The exercise of that name, with or without its chapter. Throws CannotBegin.
const Suite& suite_named(const Run& run, const std::string& name);

/// Prints the scores that change, and how many of what kind; says so when none
/// does.
void print_changes(const std::vector<Change>& changes);

}  // namespace grader
