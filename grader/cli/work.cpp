// Both ends of grading on a cluster: run --executor slurm, and the hidden
// grader work JOB CHUNK, which nodes run.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "course/report/text.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/slurm_chunk.h"
#include "grader/pipeline/slurm_executor.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

// ---- the head

std::vector<std::string> words_in(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

void say(const std::string& text) {
    fmt::print(stderr, "{}{}\n", ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "",
               course::visible(text));
}

std::string groups_of(const Bench& bench) {
    const ControlGroups& groups = bench.stage().groups();
    const bool used =
        bench.isolation() != Isolation::none && !groups.folders().empty();
    return used ? groups.text() : "";
}

// ---- a node

struct WorkOptions {
    fs::path job;
    std::size_t chunk = 0;
};

std::atomic<bool> disturbed = false;

void on_disturbance(int) {
    disturbed = true;
}

/// Cores that Slurm gives to this chunk; 0, and so all, where it does not say.
int lanes() {
    const char* cores = std::getenv("SLURM_CPUS_PER_TASK");
    return cores == nullptr ? 0 : std::clamp(std::atoi(cores), 1, 64);
}

void check_build(const Job& job) {
    std::string here;
    try {
        here = build_version(exercises_of(job));
    } catch (const std::exception& error) {
        here = error.what();
    }
    if (here != job.build)
        throw CannotBegin(fmt::format(
            "this node would judge otherwise than the head: the grader, the "
            "suites or headers in {}, or the compiler, are others ({} instead "
            "of {}).\nNothing was judged.",
            course::build_root().string(), here, job.build));
}

void check_groups(const Conditions& wanted, const Bench& bench) {
    if (!wanted.groups.empty() && groups_of(bench) != wanted.groups)
        throw CannotBegin(fmt::format(
            "this node does not bound a step as the head does: {} instead of "
            "{}. Start the head on a machine that is like the nodes.\nNothing "
            "was judged.",
            bench.stage().groups().text(), wanted.groups));
}

Job job_in(const JobFolder& folder, std::size_t chunk) {
    const auto job = folder.job();
    if (!job)
        throw CannotBegin(fmt::format("{} has no job of this grader's version",
                                      folder.path().string()));
    if (chunk >= job->chunks())
        throw CannotBegin(
            fmt::format("the job has chunks 0 to {}", job->chunks() - 1));
    return *job;
}

int work_command(const WorkOptions& options) {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    fmt::print(stderr, "chunk {} on {}\n", options.chunk, host.data());
    const JobFolder folder(options.job);
    const Job job = job_in(folder, options.chunk);
    check_build(job);
    const Conditions& wanted = job.conditions;
    const Bench bench({lanes(), wanted.seed, wanted.repeats, wanted.isolation});
    check_groups(wanted, bench);
    // Slurm thaws a job before it ends it, and when it was suspended.
    for (const int signal : {SIGTERM, SIGINT, SIGCONT})
        std::signal(signal, on_disturbance);
    LocalExecutor executor(bench.jobs(), {wanted.seed, wanted.repeats},
                           [&](int lane) { return bench.workplace(lane); });
    if (judge_chunk(folder, job, options.chunk, executor,
                    []() -> bool { return disturbed; }))
        return 0;
    fmt::print(stderr, "ended or suspended by the cluster\n");
    return 1;
}

}  // namespace

void ExecutorOptions::add_to(CLI::App& app) {
    app.add_option("--executor", name,
                   "who judges: local (this machine, the default) or slurm (a "
                   "cluster, see grader/cluster.md)")
        ->check(CLI::IsMember({"local", "slurm"}));
    app.add_option("--chunk", chunk,
                   "slurm: submissions judged in one go (default: by their "
                   "number, 20 to 200)")
        ->check(CLI::Range(1, 100'000));
    app.add_option("--partition", partition, "slurm: the nodes to use");
    app.add_option("--sbatch", sbatch,
                   "slurm: more arguments of sbatch, like \"--account=ab12 "
                   "--time=30\"");
    app.add_option("--grace", grace,
                   "slurm: seconds after which a file of an ended job counts "
                   "as missing (default 30)")
        ->check(CLI::Range(0, 3600));
}

std::unique_ptr<Executor> executor_for(const ExecutorOptions& options,
                                       const Bench& bench,
                                       const Judging& judging,
                                       const fs::path& out) {
    if (options.name == "local")
        return std::make_unique<LocalExecutor>(
            bench.jobs(), judging,
            [&bench](int lane) { return bench.workplace(lane); });
    std::vector<std::string> arguments = words_in(options.sbatch);
    if (!options.partition.empty())
        arguments.push_back("--partition=" + options.partition);
    return std::make_unique<SlurmExecutor>(
        fs::absolute(out) / "slurm",
        Conditions{judging.seed, judging.repeats, bench.isolation(),
                   groups_of(bench)},
        std::make_unique<SlurmQueue>(arguments),
        SlurmOptions{options.chunk, std::chrono::seconds(options.grace), say});
}

void add_work(CLI::App& program, int& code) {
    auto options = std::make_shared<WorkOptions>();
    CLI::App* command = program.add_subcommand(
        "work", "Judge a chunk of a job on a cluster; started by its nodes");
    command->group("");  // nobody types it
    command->add_option("job", options->job, "the folder of the job")
        ->required();
    command->add_option("chunk", options->chunk, "its number")->required();
    command->footer(
        "Exit code: 0 all of it has results, 1 it was ended before, 2 this "
        "node cannot\njudge as the head does, 3 the grader itself failed.");
    command->callback([options, &code] { code = work_command(*options); });
}

}  // namespace grader
