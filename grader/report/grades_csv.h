// grades.csv: the table that an instructor's other tools read.
#pragma once

#include <string>

#include "grader/report/class_summary.h"

namespace grader {

/// `student,total,max,percent,status` and a column per exercise, named as the
/// exercise; a line per student, by the name of the folder. UTF-8, LF.
///
/// total and max are weighted as the assignment says; the columns of the
/// exercises are the points of their suites, not weighted, 0 when nothing was
/// handed in. status is the first of these that holds:
///   grader fault       an exercise ended in one
///   not judged         an exercise has no result yet
///   nothing submitted  no file was handed in
///   partial            some exercises were not handed in
///   complete           every exercise was handed in and judged
/// In the first two, total, percent and the exercises without a result are
/// empty: a spreadsheet must not take them for a grade of zero.
/// Where an instructor has set points by hand, these count, and a last column
/// `set by hand` says for each student of which exercises and why.
/// total is what counts after lateness. Further columns stand where there is
/// something to say: `submitted` (ISO 8601, UTC) where times are known, `late`
/// ("2 days late, 80 % counts") where there is a due date, and `name`, `number`
/// and `email` of a class from a platform's export: there each member of a team
/// has a line.
std::string grades_csv(const ClassSummary& results);

}  // namespace grader
