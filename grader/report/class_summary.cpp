#include "grader/report/class_summary.h"

#include "course/report/explain.h"
#include "course/report/text.h"
#include "grader/pipeline/mistakes.h"

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

void count_mistake(ClassSummary& all, std::size_t k,
                   const ExerciseResult& result) {
    const auto found =
        recognised(all.mistakes, all.exercises[k].exercise, result);
    if (!found) return;
    MistakeCount& sum = all.recognised[{k, found->mistake}];
    sum.mistake = found->mistake;
    sum.hint = found->hint;
    sum.students.push_back(all.students.size());
}

/// One file that was handed in, with what it reached at last.
struct Try {
    std::string when, source;
    double points = 0;
    bool accepted = false;
};

/// Of one exercise; a file that was only judged again is no other try.
std::vector<Try> tries_of(const std::vector<HistoryEntry>& history,
                          const std::string& exercise) {
    std::vector<Try> tries;
    for (const HistoryEntry& entry : history) {
        if (entry.exercise != exercise || entry.proposed ||
            entry.kind != HistoryEntry::Kind::judged ||
            entry.verdict >= Verdict::not_submitted)
            continue;
        const bool again = !tries.empty() && !entry.source.empty() &&
                           tries.back().source == entry.source;
        if (!again) tries.push_back({entry.when, entry.source});
        tries.back().points = entry.points;
        tries.back().accepted = entry.verdict == Verdict::accepted;
    }
    return tries;
}

void add_time(ClassSummary& all, const Try& one) {
    try {
        all.attempts.push_back({instant_of(one.when), one.accepted});
    } catch (const TimeError&) {  // no time: not on the time line
    }
}

void look_for_standstill(ClassSummary& all, std::size_t k,
                         const std::vector<Try>& tries) {
    constexpr int patience = 2;  // attempts
    const std::size_t student = all.students.size() - 1;
    const auto& score = all.students[student][k];
    if (tries.empty() || !was_judged(score) || score->by_hand ||
        score->verdict == Verdict::accepted)
        return;
    std::size_t best = 0;
    for (std::size_t n = 1; n < tries.size(); ++n)
        if (tries[n].points > tries[best].points) best = n;
    const int in_vain = static_cast<int>(tries.size() - 1 - best);
    if (in_vain >= patience)
        all.stuck.push_back({student, k, static_cast<int>(tries.size()),
                             in_vain, tries[best].points, tries[best].when});
}

}  // namespace

void add_history(ClassSummary& all, const std::vector<HistoryEntry>& history) {
    for (std::size_t k = 0; k < all.exercises.size(); ++k) {
        const auto tries = tries_of(history, all.exercises[k].exercise);
        for (const Try& one : tries) add_time(all, one);
        look_for_standstill(all, k, tries);
    }
}

void add(ClassSummary& all, const StudentResults& student) {
    for (std::size_t k = 0; k < all.exercises.size(); ++k) {
        const auto& result = student.exercises[k];
        if (!result) continue;
        count_cases(all, k, *result);
        count_mistake(all, k, *result);
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
