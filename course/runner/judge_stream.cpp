#include "course/runner/judge_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "course/runner/codec.h"

namespace course {

namespace {

constexpr char plan_frame = 'p';
constexpr char case_frame = 'c';
constexpr char end_frame = 'e';
constexpr std::uint64_t longest_frame = std::uint64_t{64} << 20;

struct FrameStart {
    std::uint64_t length;
    std::uint64_t kind;
};

/// Whether points can be counted by the plan: 0 or more each, and a number.
bool is_countable(const std::vector<CaseInfo>& plan) {
    constexpr double most = 1'000'000;
    return std::all_of(plan.begin(), plan.end(), [](const CaseInfo& planned) {
        return planned.points >= 0 && planned.points <= most;
    });
}

/// What the report says of a case. Nothing, or more than one thing, or no
/// verdict that there is: the default, which is a grader fault.
CaseResult only_result(const JudgeReport& report, const std::string& name) {
    const auto is_it = [&](const CaseResult& r) { return r.info.name == name; };
    const auto& all = report.results;
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    if (std::count_if(all.begin(), all.end(), is_it) != 1) return {};
    if (found->verdict < Verdict::accepted ||
        found->verdict > Verdict::grader_fault)
        return {};
    return *found;
}

}  // namespace

void JudgeStream::send(char kind, const std::string& body) {
    const FrameStart start{body.size(), static_cast<std::uint64_t>(kind)};
    if (!write_all(out_.get(), &start, sizeof start) ||
        !write_all(out_.get(), body.data(), body.size()))
        throw SystemError("nobody reads the results");
}

void JudgeStream::plan(const std::vector<CaseInfo>& cases) {
    send(plan_frame, encode(cases));
}

void JudgeStream::report(const CaseResult& result) {
    send(case_frame, encode(result));
}

void JudgeStream::end() {
    send(end_frame, "");
}

JudgeReport read_judge_stream(int fd, Clock::time_point until) {
    JudgeReport report;
    std::string bytes;
    FrameStart start{};
    while (!report.ended) {
        if (receive_all(fd, bytes, sizeof start, until) != Transfer::done)
            break;
        std::memcpy(&start, bytes.data(), sizeof start);
        if (start.length > longest_frame ||
            receive_all(fd, bytes, start.length, until) != Transfer::done)
            break;
        if (start.kind == plan_frame && !report.planned)
            report.planned = decode<std::vector<CaseInfo>>(bytes);
        else if (start.kind == case_frame && report.planned)
            report.results.push_back(decode<CaseResult>(bytes));
        else if (start.kind == end_frame && start.length == 0)
            report.ended = true;
        else
            break;  // no judge says so
    }
    return report;
}

ExerciseResult result_of(const JudgeReport& report) {
    ExerciseResult result;
    if (!report.planned || report.planned->empty()) {
        result.message = "the judge did not say which cases it runs";
        return result;
    }
    if (!is_countable(*report.planned)) {
        result.message = "the judge promised points that are no such number";
        return result;
    }
    result.verdict = Verdict::accepted;
    for (const CaseInfo& planned : *report.planned) {
        CaseResult done = only_result(report, planned.name);
        done.info = planned;
        result.verdict = std::max(result.verdict, done.verdict);
        result.cases.push_back(std::move(done));
    }
    if (report.results.size() > report.planned->size()) {
        result.verdict = Verdict::grader_fault;
        result.message = "the judge reported more cases than it planned";
    }
    if (!report.ended) {
        result.verdict = Verdict::grader_fault;
        result.message = "the judge did not come to its end";
    }
    return result;
}

double ExerciseResult::points() const {
    double sum = 0;
    for (const CaseResult& c : cases)
        if (c.verdict == Verdict::accepted) sum += c.info.points;
    return sum;
}

double ExerciseResult::max() const {
    double sum = 0;
    for (const CaseResult& c : cases) sum += c.info.points;
    return sum;
}

}  // namespace course
