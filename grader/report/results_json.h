// The results of a class as JSON, for other programs.
#pragma once

#include <string>

#include "grader/report/class_results.h"

namespace grader {

/// All that counts in the newest run, for the instructor: nothing is hidden.
///
///   format      "half-edge course results"; version 1, raised when a field
///               changes its meaning or goes
///   assignment  name, max, rounding, exercises:
///                 exercise ("01_traversal/prev"), file, weight, is_bonus, max,
///                 suite (its version)
///   run         started_at (ISO 8601, UTC), grader (its version), sandbox,
///               seed (a string: it has 64 bits), notes
///   students    id (safe in file names), name (of the folder), people (name,
///               number and email on the platform; of a team several), status
///               as in grades.csv, total (none without a grade), max,
///               submitted_at (none where it is not known), days_late,
///               late_cost (points), notes, exercises:
///                 exercise, verdict, points (that count), is_set_by_hand, max,
///                 message, cases:
///                   name, is_hidden, verdict, points, max, hint, printed,
///                   failures: call, expected, got, note, mesh (its name)
///
/// An exercise without a result yet is null. Points of exercises and cases are
/// those of the suites, not weighted. Verdicts are named as by `grader judge
/// --json`. Texts that students may have chosen are UTF-8, with what cannot be
/// seen spelled out; long ones are cut in the middle. Equal results give equal
/// bytes. Throws GradebookError.
std::string results_json(const Gradebook& gradebook,
                         const Assignment& assignment);

}  // namespace grader
