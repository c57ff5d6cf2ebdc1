// grader run DIR --out OUT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "grader/cli/class_session.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"

namespace grader {

namespace {

void print_summary(const ClassRunResult& done, const ClassOptions& options) {
    if (done.unchanged > 0)
        fmt::print("{} submissions were unchanged and not graded again.\n",
                   done.unchanged);
    fmt::print("{} submissions were graded.\n", done.judged);
    if (done.faults > 0)
        fmt::print(
            "{} ended in a grader fault, which is no grade: run the "
            "command again to retry them.\n",
            done.faults);
    fmt::print("\nReport:     {}\nGrades:     {}\nPer student: {}\n",
               (options.out / "report.html").string(),
               (options.out / "grades.csv").string(),
               (options.out / "students").string());
}

bool has_fault(const ClassSummary& results) {
    return std::any_of(results.students.begin(), results.students.end(),
                       [](const Scores& student) {
                           return status(student) == Status::grader_fault;
                       });
}

int run_command(const ClassOptions& options) {
    ClassSession session(options);
    const ClassRunResult done = session.grade(false);
    const ClassSummary results =
        write_reports(session.gradebook(), session.assignment(), options.out);
    fmt::print("{}\n", class_table(results, colour_of(STDOUT_FILENO)));
    print_summary(done, options);
    if (done.stopped) {
        fmt::print(
            "Stopped before the end: run the same command again to go "
            "on.\n");
        return 1;
    }
    return has_fault(results) ? 1 : 0;
}

}  // namespace

void add_run(CLI::App& program, int& code) {
    auto options = std::make_shared<ClassOptions>();
    CLI::App* command = program.add_subcommand(
        "run",
        "Grade a class: a folder or an archive with a folder or an archive "
        "for each student");
    options->add_to(*command);
    command->footer(
        "What is recorded in OUT is never graded again; a run that was cut "
        "short goes on.\nExit code: 0 every submission got its grade, 1 one "
        "ended in a grader fault or the\nrun was stopped, 2 wrong usage, 3 the "
        "grader itself failed.");
    command->callback([options, &code] { code = run_command(*options); });
}

}  // namespace grader
