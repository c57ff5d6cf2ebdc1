// Ways of grading, one function each: this grader, and what it is compared to.
// The others run a submission as the user who calls them: only for our own.
#pragma once

#include <filesystem>

#include "grader/bench/made_class.h"
#include "grader/bench/measure.h"

namespace grader::bench {

/// This grader on a class, results into `out`. Throws as seconds_of.
Measured grade(const MadeClass& made, const std::filesystem::path& out,
               int jobs);

/// What it said on how submissions are kept apart.
std::string isolation_of(const Measured& run);

// Each takes an empty folder `scratch` of its own, or one of earlier calls, and
// throws as seconds_of.

/// The floor: the compiler alone makes an object of the file; seconds.
double compile_alone(const HandedIn& handed,
                     const std::filesystem::path& scratch);

/// One compiler command for everything, Catch2's main too, and a run of the
/// program. What the course has for all exercises is linked, not compiled.
double one_command(const HandedIn& handed,
                   const std::filesystem::path& scratch);

/// A CMake project for the submission: configure, build with Ninja, run. Catch2
/// and what the course has for all exercises are compiled already.
double cmake_project(const HandedIn& handed,
                     const std::filesystem::path& scratch);

}  // namespace grader::bench
