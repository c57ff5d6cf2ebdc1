// report.html: the results of a class, for the instructor.
#pragma once

#include "grader/report/class_results.h"
#include "grader/report/html.h"

namespace grader {

/// The whole page. Shows names of hidden cases: not for students.
Html class_page(const ClassResults& results);

/// A case of a suite, and how many failed it.
struct CaseCount {
    std::string exercise;
    std::string name;
    course::Visibility visibility = course::Visibility::hidden;
    int failed = 0;
    int judged = 0;  ///< submissions that came so far as to run it
};

/// The cases that some submission failed, most failed first. Submissions that
/// were not run at all (compile errors) say nothing about a case.
std::vector<CaseCount> most_failed(const ClassResults& results);

}  // namespace grader
