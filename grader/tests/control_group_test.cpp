// Control groups: what a step may use in all, and that nothing of it stays.
#include "grader/sandbox/control_group.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <memory>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"
#include "grader/tests/process_stat.h"

namespace fs = std::filesystem;

using grader::ControlGroup;
using grader::ControlGroups;

namespace {

bool has_groups(const ControlGroups& groups) {
    if (!groups.folders().empty()) return true;
    WARN("skipped: this machine lets us make no control group");
    return false;
}

/// Runs a shell command as a member of the group.
course::Finished in_group(const ControlGroup& group,
                          const std::string& script) {
    std::string join;
    for (const fs::path& file : group.members())
        join += fmt::format("echo 0 > '{}' || exit 98; ", file.string());
    course::Command command;
    command.arguments = {"sh", "-c", join + script};
    command.environment = course::plain_environment();
    return course::run(command, std::chrono::seconds(60), 4096);
}

/// The shell holds so many MiB in a variable.
std::string take_memory(int mib) {
    return fmt::format("x=$(head -c {} /dev/zero | tr '\\0' 'x'); echo ${{#x}}",
                       mib << 20);
}

}  // namespace

TEST_CASE("a group that takes too much memory is stopped, another is not") {
    const ControlGroups groups;
    if (!has_groups(groups)) return;
    if (groups.text().find("memory") == std::string::npos) return;
    const ControlGroup small(groups, "small", 48, 32);
    const ControlGroup large(groups, "large", 512, 32);
    const course::Finished stopped = in_group(small, take_memory(100));
    INFO(stopped.output);
    CHECK(stopped.status != 0);
    const course::Finished done = in_group(large, take_memory(100));
    INFO(done.output);
    CHECK(done.status == 0);
    CHECK(done.output == "104857600\n");
}

TEST_CASE("a group has only so many processes") {
    const ControlGroups groups;
    if (!has_groups(groups)) return;
    const ControlGroup group(groups, "few", 512, 4);
    const course::Finished bomb = in_group(
        group, "for k in 1 2 3 4 5 6 7 8; do sleep 5 & done; echo all");
    INFO(bomb.output);
    CHECK(bomb.output.find("all") == std::string::npos);
}

TEST_CASE(
    "what still runs when a group ends is killed, and the group is gone") {
    const ControlGroups groups;
    if (!has_groups(groups)) return;
    std::vector<fs::path> files;
    pid_t left = 0;
    const course::TemporaryFolder folder;
    const fs::path told = folder / "pid";
    {
        const ControlGroup group(groups, "left", 512, 8);
        files = group.members();
        const course::Finished gone = in_group(
            group, fmt::format("setsid sleep 600 >/dev/null 2>&1 & echo $! > "
                               "'{}'",
                               told.string()));
        CHECK(gone.status == 0);
        std::ifstream(told) >> left;
        REQUIRE(left > 0);
        CHECK(::kill(left, 0) == 0);
    }
    for (const fs::path& file : files) CHECK_FALSE(fs::exists(file));
    // Ended; whether somebody has collected it yet is not ours to say.
    const auto stat =
        grader::tests::process_stat(fmt::format("/proc/{}", left));
    CHECK((!stat || stat->state == 'Z'));
}

TEST_CASE("a group whose limits the kernel refuses leaves nothing behind") {
    const ControlGroups groups;
    if (!has_groups(groups)) return;
    CHECK_THROWS_AS(ControlGroup(groups, "refused", -1, -1),
                    course::SystemError);
    for (const auto& group : groups.folders())
        CHECK_FALSE(fs::exists(group.folder / "refused"));
}

TEST_CASE("this process is where it was when the last of its groups ends") {
    const std::string before = course::read_file("/proc/self/cgroup");
    // The cases before this one have had groups, too.
    CHECK(before.find(fmt::format("-{}-self", ::getpid())) ==
          std::string::npos);
    auto first = std::make_unique<ControlGroups>();
    auto second = std::make_unique<ControlGroups>();
    CHECK(second->folders().size() == first->folders().size());
    std::vector<fs::path> made;
    for (const auto& group : first->folders()) made.push_back(group.folder);
    for (const auto& group : second->folders()) made.push_back(group.folder);
    first.reset();
    { const ControlGroup still_works(*second, "step", 64, 8); }
    second.reset();
    CHECK(course::read_file("/proc/self/cgroup") == before);
    for (const fs::path& folder : made) CHECK_FALSE(fs::exists(folder));
}

TEST_CASE("groups of a process that is gone are removed by the next one") {
    const ControlGroups groups;
    if (!has_groups(groups)) return;
    std::vector<fs::path> stale;
    for (const auto& group : groups.folders()) {
        // No process has this number: the kernel's largest is 2^22.
        stale.push_back(group.folder.parent_path() /
                        "half-edge-grader-99999999-1");
        fs::create_directory(stale.back());
        fs::create_directory(stale.back() / "run-0");
    }
    const ControlGroups next;
    for (const fs::path& folder : stale) CHECK_FALSE(fs::exists(folder));
    CHECK(next.folders().size() == groups.folders().size());
    for (const auto& group : groups.folders()) CHECK(fs::exists(group.folder));
}
