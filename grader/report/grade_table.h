// Grades on their way into the table of a course platform: whose row is whose,
// and what is left.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grader/pipeline/platform_names.h"
#include "grader/report/class_summary.h"
#include "grader/report/csv_table.h"

namespace grader {

/// The grade of one submission.
struct Grade {
    std::string student;  ///< name of the folder: any bytes
    std::string key;      ///< what the platform knows them by; may be empty
    std::string person;   ///< their name, or that of the team
    std::optional<double> total = {};  ///< none: not graded, see `status`
    double max = 0;
    Status status = Status::not_judged;
    std::string feedback =
        {};  ///< one line for the student, without their words
};

/// Of every student of the run; `from` is where their names come from.
std::vector<Grade> grades_for(const ClassSummary& results, Platform from);

/// A row of a platform's table, and whose it may be.
struct PersonRow {
    std::size_t row = 0;
    std::vector<std::string> keys;   ///< the surest first; may be empty
    std::vector<std::string> names;  ///< names, logins, addresses
    std::string group;               ///< the team; may be empty
};

/// Which grade goes into which row.
struct Matches {
    struct Pair {
        std::size_t grade, row;
    };
    std::vector<Pair> pairs;        ///< in the order of the rows
    std::vector<std::string> left;  ///< students and rows without the other
};

/// A grade goes where its key is; else to the row that has the whole name of
/// its folder as a key or name; else to all rows of its team. Never by the name
/// within the folder's: the table may be that of another assignment. Where two
/// rows or two students fit, neither is taken.
Matches match(const CsvTable& table, const std::vector<Grade>& grades,
              const std::vector<PersonRow>& rows);

/// A table with grades, and every student and row that has none.
struct FilledTable {
    std::string text;
    int filled = 0;                  ///< rows with a grade of ours
    std::vector<std::string> notes;  ///< what was found in the table
    std::vector<std::string> left;   ///< what was not done, and why
};

/// The points of a grade in a table whose most is `max`.
double scaled(const Grade& grade, double max);

/// Notes that points are scaled, where they are.
void note_scale(FilledTable& table, const std::vector<Grade>& grades,
                double max);

/// "anna.rossi: grader fault, not a grade: the row stays as it is".
std::string without_grade(const Grade& grade);

}  // namespace grader
