#include "course/cli/check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>

#include "course/cli/commands.h"
#include "course/cli/explain_result.h"
#include "course/cli/progress.h"
#include "course/report/text.h"
#include "course/runner/judge_submission.h"
#include "course/runner/make_ready.h"
#include "course/runner/pool.h"

namespace course {

namespace {

namespace fs = std::filesystem;

void require_file(const fs::path& file) {
    if (!fs::is_regular_file(file))
        throw CannotBegin(fmt::format("{} is no file", file.string()));
}

int check_one(const Desk& desk, const std::string& name, const fs::path& file) {
    const Exercise exercise = exercise_or_current(desk, name);
    require_file(file.empty() ? desk.file(exercise) : file);
    make_ready({exercise}, {JudgeKind::lab});
    const ExerciseResult result =
        file.empty() ? check_mine(desk, exercise) : check_file(exercise, file);
    fmt::print("{}", file.empty() ? explain_mine(desk, exercise, result)
                                  : explain_result(exercise, file, result));
    return exit_code(result.verdict);
}

/// What was judged, and what came out.
struct Checked {
    std::string text;
    ExerciseResult result;
};

/// Precondition: the suite is built.
Checked check_now(const Desk& desk, const Exercise& exercise) {
    const fs::path file = desk.file(exercise);
    require_file(file);
    std::string text = read_file(file);
    return {std::move(text), check_file(exercise, file)};
}

void note(Progress& progress, const Exercise& exercise,
          const Checked& checked) {
    if (checked.result.verdict != Verdict::grader_fault)
        progress.note(exercise, checked.text,
                      checked.result.verdict == Verdict::accepted);
}

}  // namespace

int check_all(const Desk& desk) {
    const std::vector<Exercise> all = all_exercises();
    const std::vector<Exercise> some = begun(desk, all);
    const bool at_terminal = ::isatty(2) == 1;
    const auto results = check_many(desk, some, [&](std::size_t done) {
        if (at_terminal)
            fmt::print(stderr, "\r{} of {} checked{}", done, some.size(),
                       done == some.size() ? "\r\033[K" : "");
    });
    fmt::print("{}{} not begun.\n", table_of(some, results),
               all.size() - some.size());
    return some.size() < all.size() ? std::max(1, exit_code(results))
                                    : exit_code(results);
}

int exit_code(Verdict verdict) {
    if (verdict == Verdict::accepted) return 0;
    return verdict == Verdict::grader_fault ? 3 : 1;
}

int exit_code(const std::vector<ExerciseResult>& results) {
    int code = 0;
    for (const ExerciseResult& result : results)
        code = std::max(code, exit_code(result.verdict));
    return code;
}

ExerciseResult check_file(const Exercise& exercise, const fs::path& file) {
    LocalWorkplace workplace;
    constexpr std::uint64_t seed = 1;
    return judge_submission(workplace, exercise, file, JudgeKind::lab, {seed});
}

ExerciseResult check_mine(const Desk& desk, const Exercise& exercise) {
    Checked checked = check_now(desk, exercise);
    if (checked.result.verdict != Verdict::grader_fault)
        change_progress(desk, [&](Progress& progress) {
            progress.current = exercise.name;
            note(progress, exercise, checked);
        });
    return std::move(checked.result);
}

std::string explain_mine(const Desk& desk, const Exercise& exercise,
                         const ExerciseResult& result) {
    std::string text = explain_result(exercise, desk.file(exercise), result);
    // Where there are references, these are called in their place.
    if (result.verdict == Verdict::accepted || has_solutions()) return text;
    const Progress progress = read_progress(desk);
    for (const Exercise& before : exercises_before(exercise))
        if (progress.state(before) != State::solved)
            text += fmt::format(
                "\nIt builds on {}, which is not solved yet: see lab check "
                "{}\n",
                before.name, before.name);
    return text;
}

std::vector<ExerciseResult> check_many(
    const Desk& desk, const std::vector<Exercise>& exercises,
    const std::function<void(std::size_t)>& each) {
    make_ready(exercises, {JudgeKind::lab});
    std::vector<Checked> all(exercises.size());
    std::size_t done = 0;
    std::mutex one_at_a_time;
    for_each_item(core_count(), static_cast<int>(all.size()),
                  [&](int, int item) {
                      const auto k = static_cast<std::size_t>(item);
                      all[k] = check_now(desk, exercises[k]);
                      const std::lock_guard guard(one_at_a_time);
                      each(++done);
                  });
    change_progress(desk, [&](Progress& progress) {
        for (std::size_t k = 0; k < all.size(); ++k)
            note(progress, exercises[k], all[k]);
    });
    std::vector<ExerciseResult> results;
    for (Checked& one : all) results.push_back(std::move(one.result));
    return results;
}

std::vector<Exercise> begun(const Desk& desk,
                            const std::vector<Exercise>& exercises) {
    std::vector<Exercise> list;
    for (const Exercise& exercise : exercises)
        if (fs::exists(desk.file(exercise)) && !desk.is_untouched(exercise))
            list.push_back(exercise);
    return list;
}

std::string table_of(const std::vector<Exercise>& exercises,
                     const std::vector<ExerciseResult>& results) {
    std::string text, topic;
    std::size_t accepted = 0;
    for (std::size_t k = 0; k < exercises.size(); ++k) {
        if (exercises[k].topic != topic)
            text += fmt::format("{}\n", exercises[k].topic);
        topic = exercises[k].topic;
        const ExerciseResult& result = results[k];
        if (result.verdict == Verdict::accepted) ++accepted;
        text += fmt::format("  {:<22} {:<22}", exercises[k].name,
                            words(result.verdict));
        text +=
            result.verdict == Verdict::grader_fault
                ? result.message + "\n"
                : fmt::format("{} of {} points\n", points_text(result.points()),
                              points_text(result.max()));
    }
    return text + fmt::format("{}{} accepted, {} not accepted, ",
                              text.empty() ? "" : "\n", accepted,
                              exercises.size() - accepted);
}

void add_check(CLI::App& program, const Desk& desk, int& code) {
    struct Options {
        std::string name;
        fs::path file;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "check", "Run the public suite of an exercise on your file");
    command->add_option("exercise", options->name,
                        "its name (default: the current one), or \"all\"");
    command->add_option("--file", options->file,
                        "another file than the one in exercises/");
    command->footer(
        "Exit code: 0 accepted, 1 not accepted, 2 wrong usage, 3 "
        "the check itself failed.");
    command->callback([options, &desk, &code] {
        code = options->name == "all"
                   ? check_all(desk)
                   : check_one(desk, options->name, options->file);
    });
}

}  // namespace course
