#include "grader/report/class_summary.h"

#include "course/report/explain.h"
#include "course/report/text.h"

namespace grader {

namespace {

using course::CaseResult;
using course::ExerciseResult;
using course::Verdict;

void count_cases(ClassSummary& all, std::size_t k,
                 const ExerciseResult& result) {
    // What was not run at all (a compile error) says nothing about a case.
    if (!has_run(result)) return;
    for (const CaseResult& one : result.cases) {
        CaseCount& sum = all.cases[{k, one.info.name}];
        sum.exercise = all.exercises[k].exercise;
        sum.name = one.info.name;
        sum.visibility = one.info.visibility;
        ++sum.judged;
        if (one.verdict != Verdict::accepted) ++sum.failed;
    }
}

}  // namespace

void add(ClassSummary& all, const StudentResults& student) {
    for (std::size_t k = 0; k < all.exercises.size(); ++k) {
        const auto& result = student.exercises[k];
        if (!result) continue;
        count_cases(all, k, *result);
        if (result->verdict == Verdict::grader_fault)
            all.faults.push_back({all.students.size(), k,
                                  course::shortened(result->message, 600, 6)});
    }
    for (const auto& [k, grade] : student.by_hand)
        if (const auto& result = student.exercises[k])
            all.by_hand.push_back(
                {all.students.size(), k, grade, result->points()});
    all.students.push_back(scores_of(student));
}

}  // namespace grader
