// grader validate [EXERCISE...]
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "course/runner/make_ready.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/validate.h"

namespace grader {

namespace {

struct ValidateOptions {
    std::vector<std::string> names;
    int every = 1;
    JudgingOptions judging;
};

std::vector<course::Exercise> chosen(const std::vector<std::string>& names) {
    if (names.empty()) return course::all_exercises();
    std::vector<course::Exercise> exercises;
    for (const std::string& name : names)
        exercises.push_back(course::exercise_named(name));
    return exercises;
}

void print(const std::vector<Validation>& validations) {
    fmt::print("{:<34} {:>5} {:>6}  {:<28} {:>9}  {}\n", "exercise", "cases",
               "points", "skeleton", "wrong", "");
    for (const Validation& v : validations) {
        fmt::print("{:<34} {:>5} {:>6g}  {:<28} {:>9}  {}\n",
                   v.exercise.full_name(), v.cases, v.max, v.skeleton,
                   fmt::format("{} of {}", v.wrong_as_expected, v.wrong),
                   v.complaints.empty() ? "ok" : "NOT AS IT MUST BE");
        for (const std::string& complaint : v.complaints)
            fmt::print("    {}\n", complaint);
    }
}

int validate_command(const ValidateOptions& options) {
    ValidationRun run;
    run.exercises = chosen(options.names);
    course::make_ready(run.exercises, {course::JudgeKind::grade,
                                       course::JudgeKind::reference});
    const Bench bench(options.judging);
    run.jobs = bench.jobs();
    run.seed = options.judging.seed;
    run.repeats = options.judging.repeats;
    run.every = options.every;
    const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
    const auto validations = validate(
        run, [&](int lane) { return bench.workplace(lane); },
        [&](int done, int all) {
            if (on_terminal)
                fmt::print(stderr, "\r{} of {} submissions judged ", done, all);
        });
    if (on_terminal) fmt::print(stderr, "\r\033[K");
    print(validations);
    const auto bad = std::count_if(
        validations.begin(), validations.end(),
        [](const Validation& v) { return !v.complaints.empty(); });
    fmt::print("\n{} exercises, {} not as they must be. Seed {}, sandbox: {}\n",
               validations.size(), bad, options.judging.seed,
               bench.isolation_text());
    return bad == 0 ? 0 : 1;
}

}  // namespace

void add_validate(CLI::App& program, int& code) {
    auto options = std::make_shared<ValidateOptions>();
    CLI::App* command = program.add_subcommand(
        "validate",
        "Prove the suites: reference, skeleton and stored wrong submissions");
    command->add_option("exercise", options->names,
                        "exercises to validate (default: all)");
    command
        ->add_option("--every", options->every,
                     "of the stored wrong submissions judge every N-th only "
                     "(default 1: all)")
        ->check(CLI::PositiveNumber);
    options->judging.add_to(*command);
    command->footer(
        "Exit code: 0 all as it must be, 1 something is not, 2 wrong usage.");
    command->callback([options, &code] { code = validate_command(*options); });
}

}  // namespace grader
