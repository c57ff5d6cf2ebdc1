// Grades a class: ingest, compile, judge, record. What is recorded stays; a
// run that was cut short goes on where it stopped.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/executor.h"
#include "grader/pipeline/ingest.h"
#include "grader/pipeline/keys.h"

namespace grader {

struct ClassRun {
    std::vector<course::Exercise> exercises;  ///< those of the assignment
    SubmittedClass submitted;
    std::string only;  ///< one student, see is_named; or empty
    Judging judging;
    int jobs = 1;
    std::string isolation;  ///< in words
    bool propose = false;   ///< see Run::proposed
};

/// The keys of the run's results.
Keys keys_of(const ClassRun& run);

struct Progress {
    int done = 0;  ///< of those that have to be judged
    int all = 0;
    int failed = 0;  ///< of those done: not accepted, without faults
    int faults = 0;
};

/// What a run did.
struct ClassRunResult {
    int run = 0;  ///< its number in the gradebook
    int judged = 0;
    int unchanged = 0;  ///< had their result already
    int faults = 0;
    bool stopped = false;
};

/// Grades into the gradebook. `stop` is asked between submissions. Throws
/// GradebookError and SystemError; what was recorded before stays.
ClassRunResult grade_class(const ClassRun& run, Gradebook& gradebook,
                           Executor& executor,
                           const std::function<void(const Progress&)>& progress,
                           const std::function<bool()>& stop);

}  // namespace grader
