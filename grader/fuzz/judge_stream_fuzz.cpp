// A judge's report: whatever it says, points are given only for cases that
// were planned and reported once as accepted.
#include "course/runner/judge_stream.h"

#include <algorithm>

#include "course/report/explain.h"
#include "course/runner/codec.h"
#include "grader/fuzz/fuzz.h"

namespace {

using namespace course;

/// Whether the case is one that brings points: by its own count of the report.
bool is_passed(const JudgeReport& report, const std::string& name) {
    int reported = 0;
    int accepted = 0;
    for (const CaseResult& result : report.results) {
        if (result.info.name != name) continue;
        ++reported;
        accepted += result.verdict == Verdict::accepted;
    }
    return reported == 1 && accepted == 1;
}

void check_cases(const JudgeReport& report, const ExerciseResult& result) {
    double points = 0;
    bool all_passed = report.ended && !result.cases.empty();
    for (const CaseResult& one : result.cases) {
        const bool passed = is_passed(report, one.info.name);
        all_passed = all_passed && passed;
        points += passed ? one.info.points : 0;
        fuzz::require(!name(one.verdict).empty(), "verdicts have names");
        fuzz::require(plain_text(one).size() < 100'000 || one.hint.size() > 999,
                      "what is said of a case is short");
    }
    fuzz::require(result.points() == points, "points are for passed cases");
    fuzz::require(result.points() >= 0 && result.points() <= result.max(),
                  "points are within the maximum");
    fuzz::require(result.verdict != Verdict::accepted || all_passed,
                  "accepted means that every case passed");
}

void check_plan(const JudgeReport& report, const ExerciseResult& result) {
    if (result.cases.empty()) {
        fuzz::require(result.verdict == Verdict::grader_fault,
                      "no case is a fault of the grader");
        return;
    }
    fuzz::require(report.planned &&
                      std::equal(report.planned->begin(), report.planned->end(),
                                 result.cases.begin(), result.cases.end(),
                                 [](const auto& planned, const auto& one) {
                                     return encode(planned) == encode(one.info);
                                 }),
                  "the cases are the planned ones");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile input;
    input.with(fuzz::text_of(data, size));
    try {
        const JudgeReport report = read_judge_stream(
            input.rewound(), Clock::now() + std::chrono::hours(1));
        const ExerciseResult result = result_of(report);
        check_plan(report, result);
        check_cases(report, result);
    } catch (const CodecError&) {
        return 0;  // a fault of the grader, says judge_submission
    }
    return 0;
}
