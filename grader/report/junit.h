// junit.xml: one student's results for the systems that read test reports.
#pragma once

#include <string>

#include "grader/report/class_results.h"

namespace grader {

/// A testsuite per exercise, a testcase per case. Names are unique within a
/// suite; wrong answers are failures, everything else that is not accepted is
/// an error, what was not handed in is skipped. Times are not measured: 0.
/// Hidden cases show what the feedback level allows.
std::string junit_xml(const GradedAssignment& graded,
                      const StudentResults& student);

}  // namespace grader
