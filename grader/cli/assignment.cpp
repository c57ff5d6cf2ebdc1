// grader assignment check FILE...
#include <fmt/format.h>

#include <algorithm>

#include "course/report/text.h"
#include "grader/cli/class_session.h"

namespace grader {

namespace {

std::string weight_of(const Assignment::Item& item) {
    return fmt::format("  {:<24} x {}{}\n", short_name(item.exercise),
                       course::points_text(item.weight),
                       item.is_bonus ? " (bonus)" : "");
}

std::string due_of(const Assignment& assignment) {
    if (!assignment.due) return "never";
    const DueDate& due = *assignment.due;
    return fmt::format("{} ({}), {}", text_in(due.at, due.zone), due.zone,
                       text_in(due.at, "UTC"));
}

std::string late_of(const Assignment& assignment) {
    const LatePolicy& late = assignment.late;
    if (!assignment.due) return "nothing is late";
    std::string text;
    if (late.kind == LatePolicy::Kind::none)
        text = "marked, and counts in full";
    else if (late.kind == LatePolicy::Kind::refuse)
        text = "counts nothing";
    else
        text = fmt::format("{} % less for each day that has begun",
                           course::points_text(late.percent_per_day));
    if (late.grace_minutes > 0)
        text += fmt::format("; minutes of grace: {}", late.grace_minutes);
    if (late.free_days > 0)
        text += fmt::format("; days that cost nothing: {}", late.free_days);
    if (late.last_day)
        text += fmt::format("; last day that counts: {}", *late.last_day);
    return text;
}

std::string_view words(FeedbackLevel level) {
    switch (level) {
        case FeedbackLevel::names:
            return "names";
        case FeedbackLevel::names_and_hints:
            return "names and hints";
        case FeedbackLevel::full:
            break;
    }
    return "everything";
}

std::string limits_text(const Assignment& assignment) {
    std::string text;
    for (const SharedLimits& one : limits_of(assignment))
        text += fmt::format("  {}: {}\n", one.title, text_of(one.limits));
    return text;
}

std::string summary(const Assignment& assignment) {
    std::string text = fmt::format("{}, exercises: {}\n", assignment.name,
                                   assignment.exercises.size());
    for (const Assignment::Item& item : assignment.exercises)
        text += weight_of(item);
    text += fmt::format(
        "  due: {}\n  late work: {}\n  hidden cases: {} before the due date, "
        "{} after it\n  totals: {}\n  handed in by: {}\n",
        due_of(assignment), late_of(assignment),
        words(assignment.hidden_feedback.before_due),
        words(assignment.hidden_feedback.after_due),
        assignment.rounding > 0
            ? "multiples of " + course::points_text(assignment.rounding)
            : "not rounded",
        assignment.in_teams ? "teams" : "each student alone");
    return text + limits_text(assignment);
}

/// Prints what is in the file, or all that is wrong with it.
bool is_good(const std::filesystem::path& file) {
    try {
        fmt::print("{}", summary(*assignment_in(file)));
        return true;
    } catch (const CannotBegin& error) {
        fmt::print(stderr, "{}\n", error.what());
        return false;
    }
}

int check_command(const std::vector<std::filesystem::path>& files) {
    bool good = true;
    for (const std::filesystem::path& file : files)
        good = is_good(file) && good;
    return good ? 0 : 1;
}

}  // namespace

void add_assignment(CLI::App& program, int& code) {
    auto files = std::make_shared<std::vector<std::filesystem::path>>();
    CLI::App* group =
        program.add_subcommand("assignment", "Look at assignment files");
    group->require_subcommand(1);
    CLI::App* command = group->add_subcommand(
        "check", "Say what is in them, or everything that is wrong with them");
    command->add_option("file", *files, "like grader/assignments/*.toml")
        ->required()
        ->check(CLI::ExistingFile);
    command->footer("Exit code: 0 all are good, 1 one is not, 2 wrong usage.");
    command->callback([files, &code] { code = check_command(*files); });
}

}  // namespace grader
