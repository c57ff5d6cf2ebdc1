// When students handed in, where their platform's export does not say it.
#pragma once

#include <string>

#include "grader/pipeline/ingest.h"
#include "grader/report/csv_table.h"

namespace grader {

/// Who has no time yet gets that of the newest of the files that count. Times
/// in zip files are mostly by a local clock: that of the zone is taken.
/// Throws TimeError when there is no such zone.
void take_times_of_files(SubmittedClass& submitted, const std::string& zone);

/// A time that a table gives is the one that holds. The table is
///   - Moodle's grading worksheet with its English headers: `Identifier` and
///     `Last modified (submission)`. In teams, the rows of a `Group` are its
///     members;
///   - or one of two columns, of which the first has a name, an id or a number
///     of the platform, the second a time (see instant_in), with or without a
///     header.
/// What fits nobody, or is no time, is noted with its line. Throws CsvError for
/// any other table, and TimeError when there is no such zone.
void take_times_from(const CsvTable& table, const std::string& zone,
                     bool in_teams, SubmittedClass& submitted);

/// Notes who has no time: their work counts as in time.
void note_missing_times(SubmittedClass& submitted);

}  // namespace grader
