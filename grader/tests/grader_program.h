// The grader's program as it is built, for tests that use it as people do.
#pragma once

#include <sys/wait.h>

#include <string>
#include <vector>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "grader/sandbox/sandbox.h"

namespace grader::tests {

struct Said {
    int code = -1;
    std::string text;
};

inline course::Command grader_command(
    const std::vector<std::string>& arguments) {
    course::Command command;
    command.arguments = {course::build_root() / "grader" / "grader"};
    command.arguments.insert(command.arguments.end(), arguments.begin(),
                             arguments.end());
    command.environment = course::plain_environment();
    return command;
}

/// Runs a program to its end; what it prints on both streams.
inline Said says(const course::Command& command) {
    const course::Finished finished =
        course::run(command, std::chrono::seconds(300), std::size_t{1} << 22);
    INFO(finished.output);
    REQUIRE_FALSE(finished.timed_out);
    REQUIRE(WIFEXITED(finished.status));
    return {WEXITSTATUS(finished.status), finished.output};
}

inline Said grader_says(const std::vector<std::string>& arguments) {
    return says(grader_command(arguments));
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Whether the grader judges here without being told that it may.
inline bool has_sandbox() {
    const Stage stage;
    const Probe found = probe(stage);
    if (found.isolation != Isolation::none) return true;
    WARN("skipped, no isolation on this machine: " << found.reason);
    return false;
}

}  // namespace grader::tests
