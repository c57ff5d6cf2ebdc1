// grader regrade DIR --out OUT
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "grader/cli/class_session.h"
#include "grader/cli/past_results.h"
#include "grader/report/write_reports.h"

namespace grader {

namespace {

struct RegradeOptions : ClassOptions {
    bool yes = false;
};

bool asks(const RegradeOptions& options) {
    if (options.yes) return true;
    if (::isatty(STDIN_FILENO) != 1) {
        fmt::print(
            "Nobody is there to ask, so the old grades stay: say "
            "--yes to take the new ones.\n");
        return false;
    }
    fmt::print("Take the new grades? [y/N] ");
    std::fflush(stdout);
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

/// Why what was judged cannot be taken; empty when it can.
std::string obstacle(const ClassRunResult& done) {
    if (done.stopped)
        return "Stopped before the end: run the same command again to go on.";
    if (done.faults > 0)
        return fmt::format(
            "{} submissions ended in a grader fault, which is "
            "no grade: run the command again to retry them.",
            done.faults);
    return "";
}

int regrade_command(const RegradeOptions& options) {
    expect_gradebook(options.out);
    ClassSession session(options);
    const ClassRunResult done = session.grade(true);
    fmt::print(
        "{} submissions were judged, {} are not touched by what has "
        "changed.\n",
        done.judged, done.unchanged);
    if (const std::string why = obstacle(done); !why.empty()) {
        fmt::print("{} The old grades stay.\n", why);
        return 1;
    }
    const auto changes = session.gradebook().changes(done.run);
    print_changes(changes);
    if (!changes.empty() && !asks(options)) {
        fmt::print(
            "The old grades stay. The new results are kept, and need "
            "not be judged again.\n");
        return 1;
    }
    session.gradebook().accept(done.run);
    write_reports(session.gradebook(), session.assignment(), options.out);
    fmt::print(
        "The new grades count; the old ones stay in the history.\n"
        "Report: {}\n",
        (options.out / "report.html").string());
    return 0;
}

}  // namespace

void add_regrade(CLI::App& program, int& code) {
    auto options = std::make_shared<RegradeOptions>();
    CLI::App* command = program.add_subcommand(
        "regrade",
        "Judge a class again after a suite has changed, show which scores "
        "change, and ask before they do");
    options->add_to(*command);
    command->add_flag("--yes", options->yes, "take the new grades unasked");
    command->footer(
        "Only what the change touches is judged again. Old grades stay in the "
        "gradebook's\nhistory.\nExit code: 0 the new grades count, 1 the old "
        "ones stay, 2 wrong usage, 3 the grader\nitself failed.");
    command->callback([options, &code] { code = regrade_command(*options); });
}

}  // namespace grader
