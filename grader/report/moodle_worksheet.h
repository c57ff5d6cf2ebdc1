// Moodle's grading worksheet, with the grades in it.
#pragma once

#include <string>
#include <vector>

#include "grader/report/grade_table.h"

namespace grader {

/// What is said about a worksheet, where it is not found out.
struct MoodleOptions {
    std::string grade_column;     ///< empty: "Grade", "Valutazione", ...
    std::string feedback_column;  ///< empty: "Feedback comments", ...
    bool with_feedback = true;
};

/// `worksheet` is the file that Moodle gives ("Download grading worksheet"); in
/// the result only grades and feedback comments differ. Moodle writes headers
/// in the language of its user: the column of "Participant 1234" (its number is
/// the key of a student's folder) is known by its contents, the others by words
/// of several languages or by the options. Points are scaled to the worksheet's
/// maximum and are at most that, decimals written as they are there. A row that
/// has the grade already, or may not be changed ("No"), stays as it is.
/// Throws CsvError when it is no worksheet.
/// (moodle: mod/assign/gradingtable.php, feedback/offline/importgradeslib.php)
FilledTable filled_worksheet(const std::string& worksheet,
                             const std::vector<Grade>& grades,
                             const MoodleOptions& options);

}  // namespace grader
