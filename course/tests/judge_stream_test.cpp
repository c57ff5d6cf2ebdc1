// A judge's report, whole and broken: points only for what was planned and
// reported once as accepted; everything else is a fault of the grader.
#include "course/runner/judge_stream.h"

#include <unistd.h>

#include <csignal>
#include <limits>

#include "course/runner/catch2.h"
#include "course/runner/codec.h"

using namespace course;

namespace {

const std::vector<CaseInfo> plan = {{"first", 2, Visibility::shown},
                                    {"second", 3, Visibility::hidden}};

CaseResult result(const std::string& name, Verdict verdict) {
    CaseResult r;
    r.info.name = name;
    r.info.points = 100;  // the plan's points count, not these
    r.verdict = verdict;
    return r;
}

CaseResult passed(const std::string& name) {
    return result(name, Verdict::accepted);
}

JudgeReport report_of(std::vector<CaseResult> results) {
    return {plan, std::move(results), true};
}

Clock::time_point soon() {
    return Clock::now() + std::chrono::seconds(10);
}

/// What is read from these bytes, with nothing after them.
JudgeReport read_bytes(const std::string& bytes) {
    DescriptorPair pipe = pipe_pair();
    REQUIRE(write_all(pipe.second.get(), bytes.data(), bytes.size()));
    pipe.second.reset();
    return read_judge_stream(pipe.first.get(), soon());
}

/// The bytes that a judge sends: plan, both cases, end.
std::string whole_stream() {
    DescriptorPair pipe = pipe_pair();
    {
        JudgeStream stream(std::move(pipe.second));
        stream.plan(plan);
        stream.report(passed("first"));
        stream.report(passed("second"));
        stream.end();
    }
    std::string bytes(4096, '\0');
    const ssize_t n = ::read(pipe.first.get(), bytes.data(), bytes.size());
    bytes.resize(static_cast<std::size_t>(n));
    return bytes;
}

std::string frame(std::uint64_t kind, const std::string& body) {
    return encode(std::uint64_t{body.size()}) + encode(kind) + body;
}

std::string plan_frame() {
    return frame('p', encode(plan));
}

std::string case_frame(const CaseResult& r) {
    return frame('c', encode(r));
}

/// The exercise that comes of the bytes; unreadable ones are a fault, as they
/// are for judge_submission.
ExerciseResult judged(const std::string& bytes) {
    try {
        return result_of(read_bytes(bytes));
    } catch (const CodecError&) {
        return {};
    }
}

}  // namespace

TEST_CASE("a whole report gives the points of its plan") {
    const ExerciseResult r = judged(whole_stream());
    CHECK(r.verdict == Verdict::accepted);
    CHECK(r.points() == 5);
    CHECK(r.max() == 5);
    REQUIRE(r.cases.size() == 2);
    CHECK(r.cases[1].info.visibility == Visibility::hidden);
}

TEST_CASE("a failed case costs its points and decides the verdict") {
    const ExerciseResult r = result_of(
        report_of({passed("first"), result("second", Verdict::wrong_answer)}));
    CHECK(r.verdict == Verdict::wrong_answer);
    CHECK(r.points() == 2);
}

TEST_CASE("without a plan there is a grader fault and no point") {
    CHECK(result_of({}).verdict == Verdict::grader_fault);
    CHECK(result_of({std::vector<CaseInfo>{}, {}, true}).verdict ==
          Verdict::grader_fault);
    const ExerciseResult r =
        judged(case_frame(passed("first")) + frame('e', ""));
    CHECK(r.verdict == Verdict::grader_fault);
    CHECK(r.points() == 0);
}

TEST_CASE("a case that is missing is a grader fault") {
    const ExerciseResult r = result_of(report_of({passed("first")}));
    CHECK(r.verdict == Verdict::grader_fault);
    CHECK(r.points() == 2);
    CHECK(r.max() == 5);
}

TEST_CASE("a case that was not planned is a grader fault and has no points") {
    const ExerciseResult more = result_of(
        report_of({passed("first"), passed("second"), passed("third")}));
    CHECK(more.verdict == Verdict::grader_fault);
    CHECK(more.points() == 5);
    const ExerciseResult other =
        result_of(report_of({passed("first"), passed("third")}));
    CHECK(other.verdict == Verdict::grader_fault);
    CHECK(other.points() == 2);
}

TEST_CASE("a case that is reported twice counts as not passed, in any order") {
    const CaseResult failed = result("first", Verdict::wrong_answer);
    for (const auto& twice :
         {std::vector{passed("first"), failed, passed("second")},
          std::vector{failed, passed("first"), passed("second")},
          std::vector{passed("first"), passed("second"), passed("first")},
          std::vector{passed("first"), failed}}) {
        const ExerciseResult r = result_of(report_of(twice));
        CHECK(r.verdict == Verdict::grader_fault);
        CHECK(r.cases.at(0).verdict == Verdict::grader_fault);
        CHECK(r.points() <= 3);
    }
}

TEST_CASE("a name that is planned twice is a grader fault") {
    const JudgeReport report = {std::vector<CaseInfo>{plan[0], plan[0]},
                                {passed("first"), passed("first")},
                                true};
    CHECK(result_of(report).verdict == Verdict::grader_fault);
    CHECK(result_of(report).points() == 0);
}

TEST_CASE("a verdict that does not exist is a grader fault") {
    for (const int number : {-1, 9, 1 << 20}) {
        const ExerciseResult r = result_of(report_of(
            {result("first", static_cast<Verdict>(number)), passed("second")}));
        CHECK(r.verdict == Verdict::grader_fault);
        CHECK(r.points() == 3);
    }
}

TEST_CASE("points that are negative or no number are a grader fault") {
    for (const double points :
         {-1.0, 1e300, std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
        JudgeReport report = report_of({passed("first"), passed("second")});
        report.planned->at(1).points = points;
        const ExerciseResult r = result_of(report);
        CHECK(r.verdict == Verdict::grader_fault);
        CHECK(r.points() == 0);
        CHECK(r.max() == 0);
    }
}

TEST_CASE("a stream that is cut anywhere is a grader fault") {
    const std::string bytes = whole_stream();
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        INFO("cut after " << n << " of " << bytes.size() << " bytes");
        CHECK(judged(bytes.substr(0, n)).verdict == Verdict::grader_fault);
    }
}

TEST_CASE("a frame that no judge sends ends the report before its end") {
    const std::string cases =
        case_frame(passed("first")) + case_frame(passed("second"));
    const std::string end = frame('e', "");
    CHECK(judged(plan_frame() + cases + end).verdict == Verdict::accepted);
    for (const std::string& bytes :
         {plan_frame() + frame('x', "") + cases + end,
          plan_frame() + cases + frame('e', "more"),
          plan_frame() + cases + plan_frame() + end, cases + plan_frame() + end,
          case_frame(passed("first")) + plan_frame() +
              case_frame(passed("second")) + end,
          plan_frame() + encode(std::uint64_t{1} << 60) +
              encode(std::uint64_t{'c'}) + end})
        CHECK(judged(bytes).verdict == Verdict::grader_fault);
}

TEST_CASE("garbage in a frame is a grader fault") {
    const std::string end = frame('e', "");
    for (const std::string& body :
         {std::string(), std::string(5, '\xff'), encode(plan) + "x",
          std::string(64, '\xff')}) {
        CHECK(judged(frame('p', body) + end).verdict == Verdict::grader_fault);
        CHECK(judged(plan_frame() + frame('c', body) + end).verdict ==
              Verdict::grader_fault);
    }
}

TEST_CASE("a report with a changed byte never passes a case unplanned") {
    const std::string bytes = whole_stream();
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        INFO("byte " << n);
        std::string changed = bytes;
        changed[n] = static_cast<char>(changed[n] ^ 0x55);
        const ExerciseResult r = judged(changed);
        CHECK(r.cases.size() <= plan.size());
        if (r.verdict == Verdict::accepted) CHECK(r.cases.size() == 2);
    }
}

TEST_CASE("a judge that says nothing is given up in time") {
    const DescriptorPair pipe = pipe_pair();
    const auto until = Clock::now() + std::chrono::milliseconds(50);
    const JudgeReport report = read_judge_stream(pipe.first.get(), until);
    CHECK_FALSE(report.ended);
    CHECK(result_of(report).verdict == Verdict::grader_fault);
}

TEST_CASE("a judge that nobody reads is told so") {
    DescriptorPair pipe = pipe_pair();
    pipe.first.reset();
    std::signal(SIGPIPE, SIG_IGN);  // as the programs do
    JudgeStream stream(std::move(pipe.second));
    CHECK_THROWS_AS(stream.plan(plan), SystemError);
}
