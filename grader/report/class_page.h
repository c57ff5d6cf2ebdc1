// report.html: the results of a class, for the instructor.
#pragma once

#include "grader/report/class_summary.h"
#include "grader/report/html.h"

namespace grader {

/// The whole page. Shows names of hidden cases: not for students.
Html class_page(const ClassSummary& results);

/// The cases that some submission failed, most failed first.
std::vector<CaseCount> most_failed(const ClassSummary& results);

}  // namespace grader
