// Other programs end with the one that started them.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <thread>

#include "course/runner/catch2.h"
#include "course/runner/platform.h"
#include "course/runner/process.h"

#if COURSE_LINUX
#include <sys/prctl.h>
#endif

using namespace course;
using std::chrono::milliseconds;

#if COURSE_LINUX

namespace {

Command sleeping() {
    Command command;
    command.arguments = {"sleep", "60"};
    command.environment = plain_environment();
    return command;
}

/// Collects every child that has ended; whether there is none left, soon.
bool all_are_gone() {
    const auto until = Clock::now() + std::chrono::seconds(20);
    while (Clock::now() < until) {
        if (::waitpid(-1, nullptr, WNOHANG) < 0) return true;
        std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
}

}  // namespace

TEST_CASE("programs end with a process that is killed, alone or its group") {
    // What loses its parent becomes a child of this test.
    REQUIRE(::prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
    DescriptorPair ready = pipe_pair();
    const bool whole_group = GENERATE(false, true);
    const pid_t starter = ::fork();
    if (starter == 0) {
        ::setpgid(0, 0);
        end_programs_with_this_process();
        const Process one(sleeping()), other(sleeping());
        { Process ended(sleeping()); }
        write_all(ready.second.get(), "r", 1);
        for (;;) ::pause();
    }
    char byte = 0;
    REQUIRE(read_all(ready.first.get(), &byte, 1));
    ::kill(whole_group ? -starter : starter, SIGKILL);
    CHECK(all_are_gone());
}

TEST_CASE("a command runs where it is told to, and all that it starts") {
    const auto allowed = [](std::optional<int> processor) {
        Command command;
        command.arguments = {
            "sh", "-c", "sh -c 'grep Cpus_allowed_list /proc/self/status'"};
        command.environment = plain_environment();
        command.processor = processor;
        const std::string text =
            run(command, milliseconds(10'000), 4096).output;
        return text.substr(text.find('\t') + 1);
    };
    const std::string before = allowed(std::nullopt);
    const int first = std::stoi(before);
    CHECK(allowed(first) == std::to_string(first) + "\n");
    CHECK(allowed(std::nullopt) == before);
    constexpr int no_such = 1000;
    CHECK(allowed(no_such) == before);
}

TEST_CASE("a process that ends by itself leaves nobody waiting") {
    REQUIRE(::prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
    const pid_t starter = ::fork();
    if (starter == 0) {
        end_programs_with_this_process();
        ::_exit(0);
    }
    CHECK(all_are_gone());
}

#endif
