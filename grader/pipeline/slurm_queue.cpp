#include "grader/pipeline/slurm_queue.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "course/runner/exercises.h"
#include "course/runner/process.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Kind = QueueState::Kind;

/// Slurm copies it to the node. $1: this program, $2: the job's folder. What
/// --sbatch says comes later and wins. Chunks may be begun again at any time,
/// as their results are kept one by one.
constexpr const char* script = R"(#!/bin/sh
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=2560M
#SBATCH --requeue
#SBATCH --open-mode=append
if ! [ -x "$1" ]; then
    echo "$(hostname) has no $1: the build folder must be at the same path" >&2
    exit 2
fi
[ -d "${TMPDIR:-/tmp}" ] || unset TMPDIR
exec "$1" work "$2" "$SLURM_ARRAY_TASK_ID"
)";

/// All of ours: it may say where Slurm is, and chunks get it, too.
Arguments own_environment() {
    Arguments all;
    for (char** variable = environ; *variable != nullptr; ++variable)
        all.emplace_back(*variable);
    return all;
}

course::Finished run(Arguments arguments, std::chrono::seconds most) {
    course::Command command;
    command.arguments = std::move(arguments);
    command.environment = own_environment();
    constexpr std::size_t most_bytes = 1 << 20;
    return course::run(std::move(command), most, most_bytes);
}

std::string run_well(const Arguments& arguments) {
    const course::Finished done = run(arguments, std::chrono::minutes(2));
    if (done.timed_out || done.status != 0)
        throw course::SystemError(
            fmt::format("{} failed: {}", arguments[0],
                        done.timed_out ? "no answer" : done.output));
    return done.output;
}

/// As long as a question holds up the head, even when it is to stop.
constexpr std::chrono::seconds patience{20};

/// In the name of a log, % has a meaning.
std::string literally(const fs::path& path) {
    std::string pattern;
    for (const char c : path.string())
        pattern += c == '%' ? "%%" : std::string(1, c);
    return pattern;
}

/// Slurm holds what it could not start, until its operator lets it go.
bool is_held_for_good(const std::string& reason) {
    return reason.find("equeue") != std::string::npos;
}

/// Told apart from whatever else the command may print.
constexpr const char* line_start = "grader";

QueueState state_in(const std::string& listed) {
    QueueState state{Kind::gone, ""};
    std::istringstream lines(listed);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string start, what, reason;
        words >> start >> what;
        std::getline(words >> std::ws, reason);
        if (start != line_start) continue;
        if (what != "PENDING") return {Kind::running, ""};
        if (!is_held_for_good(reason)) state = {Kind::waiting, reason};
    }
    return state;
}

}  // namespace

std::size_t SlurmQueue::most_chunks() {
    std::istringstream lines(run_well({"scontrol", "show", "config"}));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, equals;
        std::size_t value = 0;
        if (words >> name >> equals >> value && name == "MaxArraySize")
            return std::max<std::size_t>(value, 1);
    }
    throw course::SystemError("scontrol does not say MaxArraySize");
}

void SlurmQueue::submit(const fs::path& folder, std::size_t chunks) {
    const fs::path file = folder / "chunk.sh";
    std::ofstream out(file);
    out << script;
    out.close();
    if (!out) course::throw_errno("cannot write " + file.string());
    Arguments arguments = {"sbatch",
                           "--parsable",
                           fmt::format("--array=0-{}", chunks - 1),
                           "--job-name=" + folder.filename().string(),
                           "--chdir=" + folder.string(),
                           "--output=" + literally(folder) + "/log/%a"};
    arguments.insert(arguments.end(), arguments_.begin(), arguments_.end());
    const fs::path program = course::build_root() / "grader" / "grader";
    for (const fs::path& path : {file, program, folder})
        arguments.push_back(path.string());
    run_well(arguments);
}

QueueState SlurmQueue::state(const std::string& name) {
    // By name: a number that Slurm has forgotten would be an error.
    const course::Finished done =
        run({"squeue", "--noheader", "--me", "--name=" + name,
             fmt::format("--format={} %T %r", line_start)},
            patience);
    if (done.timed_out || done.status != 0) return {Kind::unknown, ""};
    return state_in(done.output);
}

void SlurmQueue::cancel(const std::string& name) {
    try {
        run({"scancel", "--name=" + name}, patience);
    } catch (const course::SystemError&) {
        // Then it ends by itself, and nobody reads its results.
    }
}

}  // namespace grader
