// Runs the judge of an exercise and reads its report.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/descriptors.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/results.h"

namespace course {

/// Which suites: lab has the shown ones, grade the hidden ones too; reference
/// is grade with the reference solution linked in.
enum class JudgeKind { lab, grade, reference };

/// "lab", "grade" or "reference".
std::string name(JudgeKind kind);

/// Where the build puts the judge of an exercise.
std::filesystem::path judge_program(const Exercise& exercise, JudgeKind kind);

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
    /// As in Command.
    std::optional<int> processor = std::nullopt;
};

/// A judge that has been started. It makes ready what takes long, says which
/// cases there are, and waits: so it can be started while the submission is
/// still being compiled.
class RunningJudge {
public:
    /// Throws SystemError.
    explicit RunningJudge(const JudgeRun& run);

    /// Lets it run its cases; the result. A judge that fails makes a grader
    /// fault that says how. At most one of the two is called, once.
    ExerciseResult result();

    /// All its cases, not run, with this verdict: for a submission that never
    /// gets as far as the judge. Throws SystemError.
    ExerciseResult instead(Verdict verdict);

private:
    ExerciseResult report(std::chrono::milliseconds most);

    Exercise exercise_;
    std::chrono::milliseconds most_;
    Descriptor go_, results_, complaints_;
    std::optional<Process> process_;
};

/// The cases that grading runs for an exercise, all with this verdict. Throws
/// SystemError.
ExerciseResult every_case(const Exercise& exercise, JudgeKind kind,
                          Verdict verdict);

/// Points of all cases that grading runs for an exercise. Throws SystemError.
double planned_points(const Exercise& exercise);

}  // namespace course
