// From the judge to the program that started it: the cases that will be run,
// then the result of each, then the end. What is missing was not passed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/descriptors.h"
#include "course/runner/results.h"

namespace course {

/// The judge's end. Throws SystemError when nobody reads.
class JudgeStream {
public:
    explicit JudgeStream(Descriptor out) : out_(std::move(out)) {}

    void plan(const std::vector<CaseInfo>& cases);
    void report(const CaseResult& result);
    void end();

private:
    void send(char kind, const std::string& body);

    Descriptor out_;
};

/// What has arrived until the judge closed its end or time was up.
struct JudgeReport {
    std::optional<std::vector<CaseInfo>> planned;
    std::vector<CaseResult> results;
    bool ended = false;  ///< the judge came to its end
};

JudgeReport read_judge_stream(int fd, Clock::time_point until);

/// The result of an exercise from a judge's report; fails closed: points only
/// for a case that was planned and reported, once, as accepted. A case that is
/// missing or comes twice, one that was not planned, points that are negative
/// or no number, and a report without an end make the exercise a grader fault.
ExerciseResult result_of(const JudgeReport& report);

}  // namespace course
