#include "course/runner/run_judge.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "course/runner/compile.h"
#include "course/runner/judge_stream.h"
#include "course/runner/process.h"

namespace course {

namespace {

std::filesystem::path judge_of(const JudgeRun& run) {
    const char* kinds[] = {"lab", "grade", "reference"};
    return build_root() / "judges" / kinds[static_cast<int>(run.kind)] /
           run.exercise.name;
}

std::string how_it_ended(int status) {
    if (WIFEXITED(status))
        return fmt::format("exit code {}", WEXITSTATUS(status));
    return fmt::format("signal {}", WTERMSIG(status));
}

}  // namespace

ExerciseResult run_judge(const JudgeRun& run) {
    constexpr int control = 3;
    constexpr int results = 4;
    DescriptorPair pipe = pipe_pair();
    const Descriptor complaints = anonymous_file();
    Command command;
    command.arguments = {judge_of(run), "--results", std::to_string(results),
                         "--seed", std::to_string(run.seed)};
    command.environment = plain_environment();
    command.descriptors = {{pipe.second.get(), results},
                           {complaints.get(), 2}};
    if (run.control) {
        command.descriptors.emplace_back(run.control.get(), control);
        command.arguments.insert(command.arguments.end(),
                                 {"--control", std::to_string(control)});
    }
    if (!run.submitted.empty())
        command.arguments.insert(command.arguments.end(),
                                 {"--submitted", run.submitted});
    Process judge(command);
    pipe.second.reset();
    const JudgeReport report =
        read_judge_stream(pipe.first.get(), Clock::now() + run.most);
    if (!report.ended) judge.kill();
    const int status = judge.wait();
    ExerciseResult result = result_of(report);
    if (!report.ended)
        result.message += fmt::format(" ({}): {}", how_it_ended(status),
                                      last_bytes(complaints.get()));
    lift_load_error(run.exercise, result);
    return result;
}

void lift_load_error(const Exercise& exercise, ExerciseResult& result) {
    for (CaseResult& c : result.cases) {
        if (c.verdict != Verdict::compile_error || c.failures.empty()) continue;
        if (result.message.empty())
            result.message = exercise.is_data
                                 ? c.failures[0].got
                                 : load_error_text(exercise, c.failures[0].got);
        c.failures.clear();
    }
}

}  // namespace course
