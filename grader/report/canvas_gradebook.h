// Canvas's gradebook, with the grades of one assignment in it.
#pragma once

#include <string>
#include <vector>

#include "grader/report/grade_table.h"

namespace grader {

/// `gradebook` is the file that Canvas exports; in the result only cells of the
/// assignment's column differ. `column` is its name, its number ("4711" of
/// "First light (4711)") or both. Students are found by ID, then by the ids of
/// other systems, then by name. Rows without ID ("Points Possible", "Manual
/// Posting") stay as they are, and so do cells with EX (excused) or N/A. Points
/// are scaled to "Points Possible", decimals written as they are there.
/// Throws CsvError when it is no gradebook, or there is no such column.
/// (canvas-lms: gradebook_exporter.rb, gradebook_importer.rb)
FilledTable filled_gradebook(const std::string& gradebook,
                             const std::vector<Grade>& grades,
                             const std::string& column);

}  // namespace grader
