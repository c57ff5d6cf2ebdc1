// What a student may read of a result. Every file that students get is made
// from what this returns and from nothing else.
#pragma once

#include "grader/report/class_results.h"

namespace grader {

/// `result` without what the level hides: of hidden cases the failures with
/// their meshes, values and walks, what was printed, and below names_and_hints
/// the hints. The text of a grader fault, which may name anything, is taken
/// away at every level; compiler messages are about the student's own file and
/// stay, cut down as in lab.
course::ExerciseResult for_student(const course::ExerciseResult& result,
                                   FeedbackLevel level);

/// What a student may read about the mistake that an exercise seems to have
/// (see pipeline/mistakes.h): a sentence, or nothing. Hidden cases take part in
/// recognising it, so that below names_and_hints there is none.
std::string mistake_for_student(const GradedAssignment& graded,
                                const StudentResults& student,
                                std::size_t exercise);

}  // namespace grader
