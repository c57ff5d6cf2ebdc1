// Checking a student's files by the public suites.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/cli/desk.h"
#include "course/runner/results.h"

namespace course {

/// Judges a file as lab does: limits of grading, no sandbox. make_ready(...,
/// {JudgeKind::lab}) comes first.
ExerciseResult check_file(const Exercise& exercise,
                          const std::filesystem::path& file);

/// Judges the student's file and remembers what came out. Throws CannotBegin
/// when there is no such file.
ExerciseResult check_mine(const Desk& desk, const Exercise& exercise);

/// What is to be told of it: explain_result, and where it was not accepted,
/// which exercises that it builds on are not solved yet.
std::string explain_mine(const Desk& desk, const Exercise& exercise,
                         const ExerciseResult& result);

/// check_mine for many, one on each core at a time; the results in their order.
/// `each` is told how many are done, by one thread at a time. Builds what is
/// not built yet.
std::vector<ExerciseResult> check_many(
    const Desk& desk, const std::vector<Exercise>& exercises,
    const std::function<void(std::size_t)>& each);

/// Checks all that is begun and prints the table; the exit code. On a terminal
/// it counts on the error stream.
int check_all(const Desk& desk);

/// All that are begun: neither missing nor as they were handed out.
std::vector<Exercise> begun(const Desk& desk,
                            const std::vector<Exercise>& exercises);

/// A line for each, below its chapter, and the sums.
std::string table_of(const std::vector<Exercise>& exercises,
                     const std::vector<ExerciseResult>& results);

/// 0 accepted, 1 not accepted, 3 grader fault.
int exit_code(Verdict verdict);

/// That of the worst of them; 0 for none.
int exit_code(const std::vector<ExerciseResult>& results);

}  // namespace course
