// Runs the judge of an exercise and reads its report.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "course/runner/descriptors.h"
#include "course/runner/exercises.h"
#include "course/runner/results.h"

namespace course {

/// Which suites: lab has the shown ones, grade the hidden ones too; reference
/// is grade with the reference solution linked in.
enum class JudgeKind { lab, grade, reference };

struct JudgeRun {
    Exercise exercise;
    JudgeKind kind = JudgeKind::lab;
    std::uint64_t seed = 1;
    /// The conversation with the launcher; none for data and for reference.
    Descriptor control;
    /// The submitted file of a data exercise.
    std::filesystem::path submitted;
    /// A judge that takes longer is ended: its limits are far below.
    std::chrono::milliseconds most{60'000};
};

/// The result; a judge that fails makes a grader fault that says how.
ExerciseResult run_judge(const JudgeRun& run);

/// Of a table's result type: the message for a submission that did not load is
/// the same in all of its cases, so it becomes the message of the exercise.
void lift_load_error(const Exercise& exercise, ExerciseResult& result);

}  // namespace course
