// grader regrade DIR --out OUT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>

#include "course/report/text.h"
#include "grader/cli/class_session.h"
#include "grader/report/write_reports.h"

namespace grader {

namespace {

struct Options : ClassOptions {
    bool yes = false;
};

std::string score_text(const std::optional<course::Verdict>& verdict,
                       double points) {
    return verdict ? fmt::format("{:g} ({})", points, words(*verdict))
                   : "no grade";
}

bool changes_score(const Change& change) {
    return !change.old_verdict || change.points != change.old_points;
}

/// The scores that change, and how many of what kind.
void print_changes(const std::vector<Change>& changes) {
    int up = 0, down = 0;
    std::set<std::string> students;
    for (const Change& change : changes) {
        if (!changes_score(change)) continue;
        ++(change.points > change.old_points ? up : down);
        students.insert(change.student);
        fmt::print("{}  {}  {} -> {}\n", course::visible(change.student),
                   change.exercise,
                   score_text(change.old_verdict, change.old_points),
                   score_text(change.verdict, change.points));
    }
    if (changes.empty()) {
        fmt::print("No grade changes.\n");
        return;
    }
    fmt::print(
        "{} scores change, of {} students: {} up, {} down. {} results "
        "change in other ways.\n",
        up + down, students.size(), up, down,
        changes.size() - static_cast<std::size_t>(up + down));
}

bool asks(const Options& options) {
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

int regrade_command(const Options& options) {
    if (!std::filesystem::exists(options.out / "gradebook.sqlite"))
        throw CannotBegin(fmt::format(
            "{}: has no gradebook.sqlite; expected the folder of an earlier "
            "`grader run`",
            options.out.string()));
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
    auto options = std::make_shared<Options>();
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
