// The student's command: check an exercise, list them, ask for a hint.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "course/cli/explain_result.h"
#include "course/cli/figures.h"
#include "course/mesh/file_defects.h"
#include "course/runner/exercises.h"
#include "course/runner/judge_submission.h"
#include "course/runner/make_ready.h"

namespace course {

namespace {

namespace fs = std::filesystem;

/// Thrown when a command cannot begin; exit code 2.
struct CannotBegin : std::runtime_error {
    using std::runtime_error::runtime_error;
};

int exit_code(Verdict verdict) {
    if (verdict == Verdict::accepted) return 0;
    return verdict == Verdict::grader_fault ? 3 : 1;
}

int check(const std::string& name, fs::path file) {
    const Exercise exercise = exercise_named(name);
    if (file.empty()) file = fs::relative(exercise.skeleton());
    if (!fs::is_regular_file(file))
        throw CannotBegin(fmt::format("{} is no file", file.string()));
    make_ready({exercise}, {JudgeKind::lab});
    LocalWorkplace workplace;
    constexpr std::uint64_t seed = 1;
    const ExerciseResult result =
        judge_submission(workplace, exercise, file, JudgeKind::lab, {seed});
    fmt::print("{}", explain_result(exercise, file, result));
    return exit_code(result.verdict);
}

/// The statement's title, without the sign of a heading.
std::string title_of(const Exercise& exercise) {
    const std::string text = read_file(exercise.statement());
    const auto start = text.find_first_not_of("# ");
    return text.substr(start, text.find('\n') - start);
}

int list() {
    std::string topic;
    for (const Exercise& exercise : all_exercises()) {
        if (exercise.topic != topic)
            fmt::print("{}{}\n", topic.empty() ? "" : "\n", exercise.topic);
        topic = exercise.topic;
        fmt::print("  {:<22} {}\n", exercise.name, title_of(exercise));
    }
    fmt::print(
        "\nStatement of an exercise: exercises/<chapter>/<name>.md; "
        "your file: <name>.cpp\nCheck it with  ./course/lab check "
        "<name>\n");
    return 0;
}

int hint(const std::string& name, int number) {
    const Exercise exercise = exercise_named(name);
    const std::vector<std::string> hints = hints_of(exercise);
    const int all = static_cast<int>(hints.size());
    if (number < 1 || number > all)
        throw CannotBegin(
            fmt::format("{} has hints 1 to {}, not {}", name, all, number));
    for (int k = 0; k < number; ++k)
        fmt::print("{}. {}\n", k + 1, hints[static_cast<std::size_t>(k)]);
    if (number < all)
        fmt::print("\nThe next one: ./course/lab hint {} {}  ({} in all)\n",
                   name, number + 1, all);
    return 0;
}

int figures(const fs::path& folder) {
    fs::create_directories(folder);
    const auto all = lecture_figures();
    for (const auto& [name, svg] : all) replace_text(folder / name, svg);
    fmt::print("{} figures are in {}.\n", all.size(), folder.string());
    return 0;
}

struct Options {
    std::string name;
    fs::path file;
    int number = 1;
};

void add_commands(CLI::App& program, Options& options, int& code) {
    CLI::App* command = program.add_subcommand(
        "check", "Run the public suite of an exercise on your file");
    command->add_option("exercise", options.name, "its name")->required();
    command->add_option("--file", options.file,
                        "another file than the one in exercises/");
    command->footer(
        "Exit code: 0 accepted, 1 not accepted, 2 wrong usage, 3 "
        "the check itself failed.");
    command->callback([&] { code = check(options.name, options.file); });

    command = program.add_subcommand("list", "All exercises by chapter");
    command->callback([&] { code = list(); });

    command = program.add_subcommand("hint", "Hints of an exercise");
    command->add_option("exercise", options.name, "its name")->required();
    command->add_option("number", options.number,
                        "how many of them (default 1)");
    command->callback([&] { code = hint(options.name, options.number); });

    command = program.add_subcommand(
        "figures", "Draw the figures of the lecture notes, as SVG");
    command->add_option("dir", options.file, "where to")->required();
    command->callback([&] { code = figures(options.file); });
}

int run_lab(int argc, char** argv) {
    CLI::App program(
        "Exercises on the half-edge table: write the function, check it, be "
        "told what went wrong in terms of half-edges.",
        "lab");
    program.require_subcommand(1);
    Options options;
    int code = 0;
    add_commands(program, options, code);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const UnknownExercise& error) {
        fmt::print(stderr, "lab: {}\n", error.what());
        return 2;
    } catch (const CannotBegin& error) {
        fmt::print(stderr, "lab: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "lab: {}\n", error.what());
        return 3;
    }
    return code;
}

}  // namespace

}  // namespace course

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    return course::run_lab(argc, argv);
}
