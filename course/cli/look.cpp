// lab list, status, next, hint: what there is to do, and help with it.
#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <memory>

#include "course/cli/commands.h"
#include "course/cli/lists.h"
#include "course/cli/progress.h"
#include "course/cli/screen.h"

namespace course {

namespace {

constexpr const char* not_translated =
    "(Questo testo non è ancora tradotto in italiano.)";

int list(const Desk& desk, const std::string& filter) {
    fmt::print("{}", list_of(found_by(filter, all_listed(language())),
                             read_progress(desk)));
    fmt::print(
        "\nStatement of an exercise: exercises/<chapter>/<name>.md; "
        "your file: <name>.cpp\nCheck it with  ./course/lab check "
        "<name>\n");
    return 0;
}

/// Solved ones whose file is another one by now.
std::string changed_since(const Desk& desk, const Progress& progress) {
    std::string names;
    for (const Exercise& exercise : all_exercises()) {
        const auto entry = progress.entries.find(exercise.name);
        const std::filesystem::path file = desk.file(exercise);
        if (entry != progress.entries.end() &&
            entry->second.state == State::solved &&
            (!std::filesystem::exists(file) ||
             mark_of(read_file(file)) != entry->second.mark))
            names += " " + exercise.name;
    }
    return names;
}

int status(const Desk& desk) {
    const Progress progress = read_progress(desk);
    fmt::print("{}", chapters_of(progress));
    const Exercise current = progress.current_exercise();
    fmt::print("\nCurrent exercise: {} ({})\n", current.name,
               desk.file(current).string());
    for (const Exercise& exercise : all_exercises())
        if (progress.state(exercise) == State::broken)
            fmt::print("{} was solved and is BROKEN now.\n", exercise.name);
    if (const std::string names = changed_since(desk, progress); !names.empty())
        fmt::print("Changed since they were accepted:{}\n", names);
    return 0;
}

int next(const Desk& desk) {
    Exercise exercise;
    bool all_solved = false;
    change_progress(desk, [&](Progress& progress) {
        exercise = progress.next_after(progress.current_exercise());
        all_solved = progress.state(exercise) == State::solved;
        progress.current = exercise.name;
    });
    if (all_solved) {
        fmt::print("Every exercise is solved.\n");
        return 0;
    }
    print_statement(exercise);
    fmt::print("\nYour file: {}\n", desk.file(exercise).string());
    return 0;
}

int hint(const Desk& desk, const std::string& name, int number) {
    const Exercise exercise = exercise_or_current(desk, name);
    const Statement statement = own_statement(exercise);
    const std::vector<std::string>& hints = statement.hints;
    const int all = static_cast<int>(hints.size());
    if (number < 1 || number > all)
        throw CannotBegin(fmt::format("{} has hints 1 to {}, not {}",
                                      exercise.name, all, number));
    if (statement.language != language()) fmt::print("{}\n", not_translated);
    for (int k = 0; k < number; ++k)
        fmt::print("{}. {}\n", k + 1, hints[static_cast<std::size_t>(k)]);
    if (number < all)
        fmt::print("\nThe next one: ./course/lab hint {} {}  ({} in all)\n",
                   exercise.name, number + 1, all);
    return 0;
}

}  // namespace

void print_statement(const Exercise& exercise) {
    constexpr std::size_t usual_columns = 80;
    const std::string text = plain_markdown(own_statement(exercise).text);
    for (const std::string& line : wrapped(text, usual_columns))
        fmt::print("{}\n", line);
}

Language language() {
    const char* name = std::getenv("LAB_LANG");
    if (name == nullptr || *name == '\0') return Language::english;
    if (const auto wanted = language_named(name)) return *wanted;
    throw CannotBegin(
        fmt::format("LAB_LANG is \"{}\": expected en or it", name));
}

Statement own_statement(const Exercise& exercise) {
    const Language wanted = language();
    Statement statement = statement_of(exercise, wanted);
    if (statement.language != wanted)
        statement.text = not_translated + ("\n\n" + statement.text);
    return statement;
}

void add_list(CLI::App& program, const Desk& desk, int& code) {
    const auto filter = std::make_shared<std::string>();
    CLI::App* command =
        program.add_subcommand("list", "All exercises by chapter");
    command->add_option("words", *filter,
                        "only those with this in chapter, name or title");
    command->callback([filter, &desk, &code] { code = list(desk, *filter); });
}

void add_status(CLI::App& program, const Desk& desk, int& code) {
    program
        .add_subcommand("status", "How far you are, and what has broken since")
        ->callback([&desk, &code] { code = status(desk); });
}

void add_next(CLI::App& program, const Desk& desk, int& code) {
    program.add_subcommand("next", "Go on to the next exercise to be solved")
        ->callback([&desk, &code] { code = next(desk); });
}

void add_hint(CLI::App& program, const Desk& desk, int& code) {
    struct Options {
        std::string name;
        int number = 1;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("hint", "Hints of an exercise");
    command->add_option("exercise", options->name,
                        "its name (default: the current one)");
    command->add_option("number", options->number,
                        "how many of them (default 1)");
    command->callback([options, &desk, &code] {
        code = hint(desk, options->name, options->number);
    });
}

}  // namespace course
