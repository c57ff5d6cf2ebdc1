// grader override STUDENT EXERCISE POINTS --reason TEXT --out OUT
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "course/report/text.h"
#include "grader/cli/class_session.h"
#include "grader/cli/commands.h"
#include "grader/cli/past_results.h"
#include "grader/pipeline/who_and_when.h"
#include "grader/report/write_reports.h"

namespace grader {

namespace {

struct OverrideOptions {
    std::string student;
    std::string exercise;
    std::optional<double> points;
    std::string reason;
    bool undo = false;
    std::filesystem::path out;
    std::filesystem::path assignment;
};

void check(const OverrideOptions& options, const Suite& suite) {
    if (options.undo == options.points.has_value())
        throw CannotBegin("expected either points or --undo");
    if (options.reason.find_first_not_of(" \t\n") == std::string::npos)
        throw CannotBegin("--reason is empty; expected why, in a few words");
    if (!options.points) return;
    if (!(*options.points >= 0 && *options.points <= suite.max))
        throw CannotBegin(fmt::format(
            "found {} points; expected 0 to {}, those of {}", *options.points,
            course::points_text(suite.max), suite.exercise));
}

void check(const OverrideOptions& options, const Gradebook& gradebook,
           const GradeByHand& grade) {
    if (!gradebook.latest(grade.student, grade.exercise))
        throw CannotBegin(fmt::format(
            "{} has no result for {} yet; expected that it was graded before",
            grade.student, grade.exercise));
    const auto holding = gradebook.set_by_hand(grade.student);
    const bool is_set = std::any_of(
        holding.begin(), holding.end(),
        [&](const auto& one) { return one.exercise == grade.exercise; });
    if (options.undo && !is_set)
        throw CannotBegin(fmt::format("nothing was set by hand for {} in {}",
                                      grade.student, grade.exercise));
}

void print_outcome(const OverrideOptions& options, const GradeByHand& grade,
                   double max) {
    if (grade.points)
        fmt::print("{}, {}: {} of {}, set by hand.\n", grade.student,
                   grade.exercise, course::points_text(*grade.points),
                   course::points_text(max));
    else
        fmt::print("{}, {}: what the grader found counts again.\n",
                   grade.student, grade.exercise);
    if (options.assignment.empty())
        fmt::print(
            "The reports show it after the next `grader run`, or when this is "
            "said with --assignment.\n");
}

int override_command(const OverrideOptions& options) {
    // Before anything is written down: a mistake in the file must show first.
    const auto assignment = assignment_in(options.assignment);
    Gradebook gradebook = gradebook_in(options.out, Gradebook::Access::write);
    const Run run = gradebook.last_run().value_or(Run());
    const Suite& suite = suite_named(run, options.exercise);
    check(options, suite);
    const GradeByHand grade = {student_named(run, options.student).id,
                               suite.exercise,
                               options.points,
                               options.reason,
                               user_name(),
                               utc_now()};
    check(options, gradebook, grade);
    gradebook.set_by_hand(grade);
    if (assignment) write_reports(gradebook, *assignment, options.out);
    print_outcome(options, grade, suite.max);
    return 0;
}

}  // namespace

void add_override(CLI::App& program, int& code) {
    auto options = std::make_shared<OverrideOptions>();
    CLI::App* command = program.add_subcommand(
        "override", "Set the points of a student's exercise by hand");
    command->add_option("student", options->student, "folder name or id")
        ->required();
    command->add_option("exercise", options->exercise, "its name")->required();
    command->add_option("points", options->points,
                        "of the exercise's suites, before weights");
    command->add_option("--reason", options->reason, "why; kept for good")
        ->required();
    command->add_flag("--undo", options->undo,
                      "what the grader found counts again");
    command->add_option("--out", options->out, "the folder of a run")
        ->required();
    command->add_option("--assignment", options->assignment,
                        "write the reports anew, with these weights");
    command->footer(
        "Nothing is overwritten: it is a row of its own in the gradebook, with "
        "your name and\nthe time, and holds for later results, too, until "
        "--undo. Students read \"set by hand\"\nand not the reason.\nExit "
        "code: 0 done, 2 wrong usage.");
    command->callback([options, &code] { code = override_command(*options); });
}

}  // namespace grader
