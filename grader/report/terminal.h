// The results of a class, and of one student, on a terminal.
#pragma once

#include <cstddef>
#include <string>

#include "grader/report/class_summary.h"

namespace grader {

/// Colours only repeat what the letters say.
enum class Colour { off, on };

/// On when `fd` is a terminal that can show colours and NO_COLOR is not set.
Colour colour_of(int fd);

/// The table of the class: a line per student with mark and points for each
/// exercise or, where they do not fit in `columns`, the points per chapter.
/// At most `columns` wide; ends with a line feed.
std::string class_table(const ClassSummary& results, Colour colour,
                        std::size_t columns = 100);

/// All that is known of one student, for the instructor: nothing is hidden.
std::string student_text(const GradedAssignment& graded,
                         const StudentResults& student, Colour colour);

}  // namespace grader
