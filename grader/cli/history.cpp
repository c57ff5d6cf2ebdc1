// grader history --out OUT, grader diff RUN RUN --out OUT
#include <fmt/format.h>

#include <algorithm>

#include "course/mesh/file_defects.h"
#include "grader/cli/commands.h"
#include "grader/cli/past_results.h"
#include "grader/report/history.h"

namespace grader {

namespace {

struct HistoryOptions {
    std::filesystem::path out;
    std::filesystem::path csv;
    std::filesystem::path json;
    int older = 0;
    int newer = 0;
};

int history_command(const HistoryOptions& options) {
    const Gradebook gradebook = gradebook_in(options.out);
    if (!options.csv.empty())
        course::replace_text(options.csv, history_csv(gradebook));
    if (!options.json.empty())
        course::replace_text(options.json, history_json(gradebook));
    fmt::print("{}", runs_text(gradebook.runs()));
    return 0;
}

void check_run(const std::vector<PastRun>& runs, int number) {
    if (std::none_of(runs.begin(), runs.end(),
                     [&](const PastRun& run) { return run.number == number; }))
        throw CannotBegin(
            fmt::format("there is no run {}; there are these:\n{}", number,
                        runs_text(runs)));
}

int diff_command(const HistoryOptions& options) {
    const Gradebook gradebook = gradebook_in(options.out);
    const std::vector<PastRun> runs = gradebook.runs();
    check_run(runs, options.older);
    check_run(runs, options.newer);
    if (options.older >= options.newer)
        throw CannotBegin(
            fmt::format("found run {} and then run {}; expected "
                        "the older one first",
                        options.older, options.newer));
    const std::vector<Change> changes =
        gradebook.differences(options.older, options.newer);
    print_changes(changes);
    return changes.empty() ? 0 : 1;
}

}  // namespace

void add_history(CLI::App& program, int& code) {
    auto options = std::make_shared<HistoryOptions>();
    CLI::App* command = program.add_subcommand(
        "history",
        "The runs of a folder; everything that happened to its grades as a "
        "file");
    command->add_option("--out", options->out, "the folder of a run")
        ->required();
    command->add_option("--csv", options->csv, "write all of it to this file");
    command->add_option("--json", options->json,
                        "write all of it, with the runs, to this file");
    command->footer("Exit code: 0, or 2 when there is no gradebook.");
    command->callback([options, &code] { code = history_command(*options); });
}

void add_diff(CLI::App& program, int& code) {
    auto options = std::make_shared<HistoryOptions>();
    CLI::App* command = program.add_subcommand(
        "diff", "The scores that differ between two runs of a folder");
    command->add_option("older", options->older, "number of a run")->required();
    command->add_option("newer", options->newer, "number of a later one")
        ->required();
    command->add_option("--out", options->out, "the folder of the runs")
        ->required();
    command->footer(
        "As the grader found them: points set by hand belong to no run. "
        "`grader "
        "history`\nlists the runs.\nExit code: 0 no result differs, 1 one "
        "does, "
        "2 wrong usage.");
    command->callback([options, &code] { code = diff_command(*options); });
}

}  // namespace grader
