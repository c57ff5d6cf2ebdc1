// Builds what judging an exercise needs: a tree has many exercises, and most
// who build it want a few of them.
#pragma once

#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "course/runner/run_judge.h"

namespace course {

/// To be called before a place is made where submissions are compiled: it
/// takes what is there then. Brings the judges of these exercises, and what
/// their submissions are linked with, up to date: seconds for each that was
/// never built, else a tenth of a second for all. One at a time builds in a
/// tree, others wait; where its build folder may not be written, things are
/// taken as they are. Throws SystemError that names the log when something does
/// not build.
void make_ready(const std::vector<Exercise>& exercises,
                const std::vector<JudgeKind>& kinds);

/// The same for other targets of the build.
void make_targets(const std::vector<std::string>& targets);

}  // namespace course
