// The parts of the benchmark. Each measures what it compares side by side, in
// rounds, and writes its rows into the report.
#pragma once

#include "grader/bench/report.h"

namespace grader::bench {

struct Settings {
    bool quick = false;  ///< few and small: shows that it works, proves little
    int students = 0;    ///< of the class; 0: what the part chooses
    int exercises = 0;
    int jobs = 2;  ///< where lanes are not what is measured
};

// Each throws MeasureError when something that is measured fails.

/// One submission: this grader, the compiler alone, and two usual graders.
void submission(const Settings& settings, Report& report);

/// A class with endless loops in it, against only compiling the same files.
void whole_class(const Settings& settings, Report& report);

/// Where the time of a submission goes.
void shares(const Settings& settings, Report& report);

/// Time and memory with more students, time with more lanes.
void scaling(const Settings& settings, Report& report);

/// From a fresh clone of what is committed to the first report.
void build(const Settings& settings, Report& report);

}  // namespace grader::bench
