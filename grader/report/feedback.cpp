#include "grader/report/feedback.h"

#include "course/report/compiler_messages.h"
#include "grader/pipeline/mistakes.h"

namespace grader {

namespace {

using course::CaseResult;

/// Built up from nothing, so that a field that is added later stays hidden.
CaseResult only_name(const CaseResult& result) {
    CaseResult shown;
    shown.info = result.info;
    shown.verdict = result.verdict;
    return shown;
}

CaseResult for_student(const CaseResult& result, FeedbackLevel level) {
    if (result.info.visibility == course::Visibility::shown ||
        level == FeedbackLevel::full)
        return result;
    CaseResult shown = only_name(result);
    if (level == FeedbackLevel::names_and_hints) shown.hint = result.hint;
    return shown;
}

}  // namespace

course::ExerciseResult for_student(const course::ExerciseResult& result,
                                   FeedbackLevel level) {
    course::ExerciseResult shown;
    shown.verdict = result.verdict;
    if (result.verdict != course::Verdict::grader_fault)
        shown.message = course::explain_compiler(result.message);
    for (const CaseResult& one : result.cases)
        shown.cases.push_back(for_student(one, level));
    return shown;
}

std::string mistake_for_student(const GradedAssignment& graded,
                                const StudentResults& student, std::size_t k) {
    const auto& result = student.exercises[k];
    if (!result || hidden_feedback(graded) == FeedbackLevel::names) return "";
    const auto found =
        recognised(graded.mistakes, graded.exercises[k].exercise, *result);
    if (!found || found->hint.empty()) return "";
    return "This looks like a mistake that we know: " + found->hint;
}

}  // namespace grader
