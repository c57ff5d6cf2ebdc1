// The verdicts of the field, for a case, an exercise, and a report.
#pragma once

#include <optional>
#include <string_view>

namespace course {

/// In order of severity: the verdict of several cases is the largest.
enum class Verdict {
    accepted,
    wrong_answer,
    run_time_error,
    memory_limit_exceeded,
    time_limit_exceeded,
    compile_error,
    forbidden_operation,
    not_submitted,
    grader_fault,
};

/// `wrong_answer` and so on: the name in files and folders.
std::string_view name(Verdict verdict);

/// "wrong answer" and so on: for people.
std::string_view words(Verdict verdict);

/// The verdict of that name, if there is one.
std::optional<Verdict> verdict_named(std::string_view name);

}  // namespace course
