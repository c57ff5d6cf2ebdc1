// report.html: the results of a class, for the instructor.
#pragma once

#include "course/report/html.h"
#include "grader/report/class_summary.h"

namespace grader {

using course::Html;

/// The whole page. Shows names of hidden cases: not for students.
Html class_page(const ClassSummary& results);

/// The cases that some submission failed, most failed first.
std::vector<CaseCount> most_failed(const ClassSummary& results);

}  // namespace grader
