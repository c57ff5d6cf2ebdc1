// lab reset NAME
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <memory>

#include "course/cli/commands.h"
#include "course/cli/progress.h"

namespace course {

namespace {

/// True where nobody sits at the terminal who could be asked.
bool is_wanted(const std::string& file) {
    if (::isatty(0) != 1 || ::isatty(1) != 1) return true;
    fmt::print("Put {} back to how it was handed out? Yours is kept. [y/N] ",
               file);
    std::fflush(stdout);
    std::string answer;
    std::getline(std::cin, answer);
    return !answer.empty() && (answer[0] == 'y' || answer[0] == 'Y');
}

int reset(const Desk& desk, const std::string& name, bool yes) {
    const Exercise exercise = exercise_named(name);
    const std::string file = desk.file(exercise).string();
    if (!yes && !is_wanted(file)) return 1;
    const auto kept = reset_exercise(desk, exercise);
    fmt::print("{} is as it was handed out.\n", file);
    if (kept) fmt::print("Yours is now {}\n", kept->string());
    return 0;
}

}  // namespace

void add_reset(CLI::App& program, const Desk& desk, int& code) {
    struct Options {
        std::string name;
        bool yes = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "reset", "Put your file back to how it was handed out; yours is kept");
    command->add_option("exercise", options->name, "its name")->required();
    command->add_flag("--yes", options->yes, "do not ask");
    command->callback([options, &desk, &code] {
        code = reset(desk, options->name, options->yes);
    });
}

}  // namespace course
