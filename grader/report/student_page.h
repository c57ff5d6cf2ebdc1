// feedback.html: the results of one student, for the student.
#pragma once

#include "grader/report/class_results.h"
#include "grader/report/html.h"

namespace grader {

/// The whole page. Of hidden cases it shows what the assignment's feedback
/// level allows (see feedback.h).
Html student_page(const GradedAssignment& graded,
                  const StudentResults& student);

}  // namespace grader
