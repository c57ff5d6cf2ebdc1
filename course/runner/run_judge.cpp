#include "course/runner/run_judge.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "course/runner/codec.h"
#include "course/runner/compile.h"
#include "course/runner/judge_stream.h"
#include "course/runner/process.h"

namespace course {

std::string name(JudgeKind kind) {
    constexpr const char* names[] = {"lab", "grade", "reference"};
    return names[static_cast<int>(kind)];
}

std::filesystem::path judge_program(const Exercise& exercise, JudgeKind kind) {
    return build_root() / "judges" / name(kind) / exercise.name;
}

namespace {

std::string how_it_ended(int status) {
    if (WIFEXITED(status))
        return fmt::format("exit code {}", WEXITSTATUS(status));
    return fmt::format("signal {}", WTERMSIG(status));
}

/// A submission that did not load says so in each of its cases; that becomes
/// the message of the exercise. It is text of the worker's, who has seen what
/// the case asked: only that of a shown case may be told.
void lift_load_error(const Exercise& exercise, ExerciseResult& result) {
    for (CaseResult& c : result.cases) {
        if (c.verdict != Verdict::compile_error || c.failures.empty()) continue;
        if (result.message.empty() && c.info.visibility == Visibility::shown)
            result.message = exercise.is_data
                                 ? c.failures[0].got
                                 : load_error_text(exercise, c.failures[0].got);
        c.failures.clear();
    }
}

/// A fault without a message of its own: what was wrong in the first case that
/// has one.
void lift_fault(ExerciseResult& result) {
    if (result.verdict != Verdict::grader_fault || !result.message.empty())
        return;
    for (const CaseResult& c : result.cases)
        if (c.verdict == Verdict::grader_fault && result.message.empty())
            result.message = c.failures.empty()
                                 ? "the judge said nothing of a case"
                                 : c.failures[0].got;
}

/// A judge that takes longer is ended: what its own limits add up to is far
/// below.
std::chrono::milliseconds patience_with(const JudgeRun& run) {
    constexpr std::chrono::milliseconds beside{30'000};
    const std::chrono::milliseconds once(run.exercise.limits.run_ms);
    return (once + beside) * static_cast<int>(run.seeds.size());
}

std::vector<std::string> arguments_of(const JudgeRun& run) {
    std::vector<std::string> list = {judge_program(run.exercise, run.kind)};
    for (const std::uint64_t seed : run.seeds)
        list.insert(list.end(), {"--seed", std::to_string(seed)});
    if (!run.submitted.empty())
        list.insert(list.end(), {"--submitted", run.submitted});
    return list;
}

}  // namespace

RunningJudge::RunningJudge(const JudgeRun& run)
    : exercise_(run.exercise),
      most_(patience_with(run)),
      complaints_(anonymous_file()) {
    constexpr int control = 3, results = 4, go = 5;
    DescriptorPair report = pipe_pair(), start = socket_pair();
    Command command;
    command.arguments = arguments_of(run);
    command.arguments.insert(
        command.arguments.end(),
        {"--results", std::to_string(results), "--go", std::to_string(go)});
    command.environment = plain_environment();
    command.processor = run.processor;
    command.descriptors = {{complaints_.get(), 2},
                           {report.second.get(), results},
                           {start.first.get(), go}};
    if (run.control) {
        command.descriptors.emplace_back(run.control.get(), control);
        command.arguments.insert(command.arguments.end(),
                                 {"--control", std::to_string(control)});
    }
    process_.emplace(command);
    results_ = std::move(report.first);
    go_ = std::move(start.second);
}

ExerciseResult RunningJudge::report(std::chrono::milliseconds most) {
    const JudgeReport report =
        read_judge_stream(results_.get(), Clock::now() + most);
    if (!report.ended) process_->kill();
    const int status = process_->wait();
    ExerciseResult result = result_of(report);
    if (!report.ended)
        result.message += fmt::format(" ({}): {}", how_it_ended(status),
                                      last_bytes(complaints_.get()));
    return result;
}

ExerciseResult RunningJudge::result() {
    // Fails when the judge has ended already; its report then tells.
    send_all(go_.get(), encode(exercise_.limits),
             Clock::now() + std::chrono::seconds(1));
    ExerciseResult result = report(most_);
    lift_load_error(exercise_, result);
    lift_fault(result);
    return result;
}

ExerciseResult RunningJudge::instead(Verdict verdict) {
    go_.reset();
    ExerciseResult result = report(std::chrono::seconds(20));
    if (result.cases.empty()) throw SystemError(result.message);
    result.message.clear();
    for (CaseResult& c : result.cases) c.verdict = verdict;
    result.verdict = verdict;
    return result;
}

ExerciseResult every_case(const Exercise& exercise, JudgeKind kind,
                          Verdict verdict) {
    JudgeRun run;
    run.exercise = exercise;
    run.kind = kind;
    return RunningJudge(run).instead(verdict);
}

double planned_points(const Exercise& exercise) {
    return every_case(exercise, JudgeKind::grade, Verdict::not_submitted).max();
}

}  // namespace course
