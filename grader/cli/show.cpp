// grader show STUDENT --out OUT
#include <fmt/format.h>
#include <unistd.h>

#include "grader/cli/commands.h"
#include "grader/cli/past_results.h"
#include "grader/report/class_results.h"
#include "grader/report/history.h"
#include "grader/report/terminal.h"

namespace grader {

namespace {

struct ShowOptions {
    std::string student;
    std::filesystem::path out;
    bool history = false;
};

int show_command(const ShowOptions& options) {
    const Gradebook gradebook = gradebook_in(options.out);
    const GradedAssignment graded =
        graded_assignment(gradebook, unweighted_assignment(gradebook));
    const Student& student = student_named(graded.run, options.student);
    fmt::print("{}",
               student_text(graded, student_results(gradebook, graded, student),
                            colour_of(STDOUT_FILENO)));
    if (options.history)
        fmt::print("\nhistory:\n{}",
                   history_text(gradebook.history(student.id)));
    return 0;
}

}  // namespace

void add_show(CLI::App& program, int& code) {
    auto options = std::make_shared<ShowOptions>();
    CLI::App* command = program.add_subcommand(
        "show", "One student's results, hidden cases included");
    command->add_option("student", options->student, "folder name or id")
        ->required();
    command->add_option("--out", options->out, "the folder of a run")
        ->required();
    command->add_flag("--history", options->history,
                      "also every result there was, and what was set by hand");
    command->footer("Exit code: 0, or 2 when there is no such student.");
    command->callback([options, &code] { code = show_command(*options); });
}

}  // namespace grader
