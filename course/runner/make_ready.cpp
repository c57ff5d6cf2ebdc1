#include "course/runner/make_ready.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "course/runner/pool.h"
#include "course/runner/process.h"

namespace course {

namespace {

namespace fs = std::filesystem;

/// Held as long as it lives. Not by other systems' build tools: who calls them
/// by hand beside this takes a chance.
Descriptor build_lock() {
    const fs::path file = build_root() / "build.lock";
    Descriptor lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (lock) ::flock(lock.get(), LOCK_EX);
    return lock;
}

std::vector<std::string> targets(const std::vector<Exercise>& exercises,
                                 const std::vector<JudgeKind>& kinds) {
    std::vector<std::string> names;
    for (const Exercise& exercise : exercises) {
        for (const JudgeKind kind : kinds)
            names.push_back(
                fmt::format("judge_{}_{}", name(kind), exercise.name));
        if (!exercise.is_data) names.push_back(exercise.name + "_entry_file");
    }
    return names;
}

bool is_built(const Exercise& exercise, const std::vector<JudgeKind>& kinds) {
    return std::all_of(kinds.begin(), kinds.end(), [&](JudgeKind kind) {
        return fs::exists(judge_program(exercise, kind));
    });
}

}  // namespace

void make_ready(const std::vector<Exercise>& exercises,
                const std::vector<JudgeKind>& kinds) {
    if (exercises.empty() || ::access(build_root().c_str(), W_OK) != 0) return;
    const auto missing = std::count_if(
        exercises.begin(), exercises.end(),
        [&](const Exercise& exercise) { return !is_built(exercise, kinds); });
    if (missing > 1)
        fmt::print(stderr, "Building the suites of {} exercises ...\n",
                   missing);
    make_targets(targets(exercises, kinds));
}

void make_targets(const std::vector<std::string>& targets) {
    if (::access(build_root().c_str(), W_OK) != 0) return;
    const Descriptor lock = build_lock();
    Command build;
    build.arguments = {COURSE_CMAKE,
                       "--build",
                       build_root(),
                       "--parallel",
                       std::to_string(core_count()),
                       "--target"};
    build.arguments.insert(build.arguments.end(), targets.begin(),
                           targets.end());
    build.environment = plain_environment();
    const Finished built =
        run(std::move(build), std::chrono::hours(2), std::size_t{1} << 20);
    if (built.status == 0 && !built.timed_out) return;
    const fs::path log = build_root() / "build.log";
    if (std::FILE* file = std::fopen(log.c_str(), "w")) {
        std::fputs(built.output.c_str(), file);
        std::fclose(file);
    }
    throw SystemError(
        fmt::format("the build fails; the whole log is in {}", log.string()));
}

}  // namespace course
