// The suites prove themselves: the reference passes, the skeleton compiles and
// fails, every stored wrong submission gets the verdict of its folder.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "course/runner/judge_submission.h"
#include "grader/pipeline/executor.h"

namespace grader {

/// What validation found out about one exercise.
struct Validation {
    course::Exercise exercise;
    double max = 0;  ///< points of all its cases
    int cases = 0;
    std::string skeleton = {};  ///< its verdict and points
    int wrong = 0;              ///< stored wrong submissions
    int wrong_as_expected = 0;
    std::vector<std::string> complaints =
        {};  ///< empty when all is as it must be
};

struct ValidationRun {
    std::vector<course::Exercise> exercises;
    int jobs = 1;
    std::uint64_t seed = 1;
    int repeats = 2;  ///< as in grading
    int every = 1;    ///< of the stored wrong submissions: every such one
};

/// Validates the exercises, several trials at a time. `progress` is called
/// with the number of trials done and of all.
std::vector<Validation> validate(
    const ValidationRun& run, const WorkplaceMaker& make_workplace,
    const std::function<void(int done, int all)>& progress);

}  // namespace grader
