// Sentences that students read about their results, in every kind of report.
#pragma once

#include <string>
#include <string_view>

#include "course/report/walk.h"
#include "course/runner/results.h"

namespace course {

/// What the verdict of an exercise means for a student.
std::string_view explanation(Verdict verdict);

/// Whether the cases could be run, so that each says something of its own.
bool has_run(const course::ExerciseResult& result);

/// What became of the file itself: accepted if its cases could be run, else the
/// verdict of all. The result's message belongs to it.
Verdict verdict_of_file(const course::ExerciseResult& result);

/// Points that the case brought: all of its points or none.
double earned(const CaseResult& result);

/// The walk of a failed check.
Walk walk_of(const Failure& failure);

/// "12, 14": the lines of the student's file that the walk read from, in the
/// order in which it first came to them; empty when not known.
std::string lines_of(const Failure& failure);

/// A failed case in plain text, for reports that have no other form: the hint,
/// then for each failure what was asked, expected and answered, and the walk.
std::string plain_text(const CaseResult& result);

}  // namespace course
