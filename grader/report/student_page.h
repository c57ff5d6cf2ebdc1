// feedback.html: the results of one student, for the student.
#pragma once

#include "course/report/html.h"
#include "grader/report/class_results.h"

namespace grader {

using course::Html;

/// The whole page. Of hidden cases it shows what the assignment's feedback
/// level allows (see feedback.h).
Html student_page(const GradedAssignment& graded,
                  const StudentResults& student);

}  // namespace grader
