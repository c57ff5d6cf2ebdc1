// results.json: one student's results in the format that Gradescope reads.
#pragma once

#include <string>

#include "grader/report/class_results.h"

namespace grader {

/// The object as text: the weighted total as `score`, and a test per case with
/// its weighted points. Hidden cases show what the feedback level allows.
/// Without a grade (a grader fault, a result still to come) there is no score
/// at all, so that none can be taken for one.
std::string gradescope_json(const GradedAssignment& graded,
                            const StudentResults& student);

}  // namespace grader
