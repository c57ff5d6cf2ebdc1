// What happened to grades, for instructors: on a terminal and as files.
#pragma once

#include <string>
#include <vector>

#include "grader/gradebook/gradebook.h"

namespace grader {

/// A line for each entry: when, what, which exercise, run and suite.
std::string history_text(const std::vector<HistoryEntry>& entries);

/// A line for each run: when, by whom, of how many exercises.
std::string runs_text(const std::vector<PastRun>& runs);

/// `when,what,student,name,exercise,run,suite,verdict,points,max,proposed,
/// source,user,reason` and a line for each entry, student after student, oldest
/// first. `what` is judged, counted_again, set_by_hand or taken_back; run,
/// suite, verdict, max, proposed and source are empty in the last two, and
/// `points` in the last. UTF-8, LF. Throws GradebookError.
std::string history_csv(const Gradebook& gradebook);

/// The same, and the runs with the version of each suite:
/// {"runs": [{run, started_at, user, grader, sandbox, seed, jobs, proposed,
/// suites: {exercise: version}}], "entries": [...]}, where an entry has the
/// columns of the CSV, without those that are empty. Throws GradebookError.
std::string history_json(const Gradebook& gradebook);

}  // namespace grader
