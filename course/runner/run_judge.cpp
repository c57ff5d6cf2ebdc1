#include "course/runner/run_judge.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "course/runner/compile.h"
#include "course/runner/judge_stream.h"
#include "course/runner/process.h"

namespace course {

namespace {

std::filesystem::path judge_of(const Exercise& exercise, JudgeKind kind) {
    const char* kinds[] = {"lab", "grade", "reference"};
    return build_root() / "judges" / kinds[static_cast<int>(kind)] /
           exercise.name;
}

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

/// Starts the judge, reads its report, and says how it ended when it broke.
ExerciseResult report_of(const Exercise& exercise, Command command,
                         std::chrono::milliseconds most) {
    constexpr int results = 4;
    DescriptorPair pipe = pipe_pair();
    const Descriptor complaints = anonymous_file();
    command.arguments.insert(command.arguments.end(),
                             {"--results", std::to_string(results)});
    command.environment = plain_environment();
    command.descriptors.emplace_back(pipe.second.get(), results);
    command.descriptors.emplace_back(complaints.get(), 2);
    Process judge(command);
    pipe.second.reset();
    const JudgeReport report =
        read_judge_stream(pipe.first.get(), Clock::now() + most);
    if (!report.ended) judge.kill();
    const int status = judge.wait();
    ExerciseResult result = result_of(report);
    if (!report.ended)
        result.message += fmt::format(" ({}): {}", how_it_ended(status),
                                      last_bytes(complaints.get()));
    lift_load_error(exercise, result);
    lift_fault(result);
    return result;
}

}  // namespace

ExerciseResult run_judge(const JudgeRun& run) {
    constexpr int control = 3;
    Command command;
    command.arguments = {judge_of(run.exercise, run.kind)};
    for (const std::uint64_t seed : run.seeds)
        command.arguments.insert(command.arguments.end(),
                                 {"--seed", std::to_string(seed)});
    if (run.control) {
        command.descriptors = {{run.control.get(), control}};
        command.arguments.insert(command.arguments.end(),
                                 {"--control", std::to_string(control)});
    }
    if (!run.submitted.empty())
        command.arguments.insert(command.arguments.end(),
                                 {"--submitted", run.submitted});
    return report_of(run.exercise, std::move(command),
                     run.most * static_cast<int>(run.seeds.size()));
}

ExerciseResult every_case(const Exercise& exercise, JudgeKind kind,
                          Verdict verdict) {
    Command command;
    command.arguments = {judge_of(exercise, kind), "--plan"};
    ExerciseResult result =
        report_of(exercise, std::move(command), std::chrono::seconds(20));
    if (result.cases.empty()) throw SystemError(result.message);
    result.message.clear();
    for (CaseResult& c : result.cases) c.verdict = verdict;
    result.verdict = verdict;
    return result;
}

double planned_points(const Exercise& exercise) {
    return every_case(exercise, JudgeKind::grade, Verdict::not_submitted).max();
}

}  // namespace course
