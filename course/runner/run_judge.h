// Runs the judge of an exercise and reads its report.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <vector>

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
    /// Every case is run once for each of them, in a fresh worker and on meshes
    /// numbered and generated from it; it must pass each time, so that luck is
    /// not enough.
    std::vector<std::uint64_t> seeds = {1};
    /// The conversation with the launcher; none for data and for reference.
    Descriptor control;
    /// The submitted file of a data exercise.
    std::filesystem::path submitted;
    /// A judge that takes longer for one run of all cases is ended: its limits
    /// are far below.
    std::chrono::milliseconds most{50'000};
};

/// The result; a judge that fails makes a grader fault that says how.
ExerciseResult run_judge(const JudgeRun& run);

/// The cases that grading runs for an exercise, all with this verdict: for a
/// submission that never gets as far as the judge. Throws SystemError.
ExerciseResult every_case(const Exercise& exercise, JudgeKind kind,
                          Verdict verdict);

/// Points of all cases that grading runs for an exercise. Throws SystemError.
double planned_points(const Exercise& exercise);

}  // namespace course
