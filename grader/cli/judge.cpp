// grader judge EXERCISE FILE.cpp [--json]
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "course/report/explain.h"
#include "course/report/text.h"
#include "course/runner/make_ready.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/keys.h"

namespace grader {

namespace {

using course::Verdict;

struct JudgeOptions {
    std::string exercise;
    std::filesystem::path file;
    bool json = false;
    JudgingOptions judging;
};

void print_json(const course::Exercise& exercise,
                const course::ExerciseResult& result) {
    nlohmann::ordered_json object;
    object["exercise"] = exercise.name;
    object["verdict"] = name(result.verdict);
    object["points"] = result.points();
    object["max"] = result.max();
    object["cases"] = nlohmann::ordered_json::array();
    for (const auto& c : result.cases)
        object["cases"].push_back(
            {{"name", c.info.name},
             {"verdict", name(c.verdict)},
             {"points", c.verdict == Verdict::accepted ? c.info.points : 0.0}});
    object["message"] = result.message;
    fmt::print("{}\n", object.dump(2, ' ', false,
                                   nlohmann::json::error_handler_t::replace));
}

void print_text(const course::Exercise& exercise,
                const course::ExerciseResult& result) {
    fmt::print("{}: {}, {} of {} points\n", exercise.name,
               words(result.verdict), course::points_text(result.points()),
               course::points_text(result.max()));
    for (const auto& c : result.cases)
        fmt::print("\n{}: {}\n{}", words(c.verdict), c.info.name,
                   c.verdict == Verdict::accepted
                       ? ""
                       : course::visible(plain_text(c)));
    if (!result.message.empty())
        fmt::print("\n{}\n", course::visible(result.message));
}

int exit_code(Verdict verdict) {
    if (verdict == Verdict::accepted) return 0;
    return verdict == Verdict::grader_fault ? 3 : 1;
}

int judge_command(const JudgeOptions& options) {
    const course::Exercise exercise = course::exercise_named(options.exercise);
    if (!std::filesystem::is_regular_file(options.file))
        throw CannotBegin(fmt::format("{} is no file", options.file.string()));
    course::make_ready({exercise}, {course::JudgeKind::grade});
    const Bench bench(options.judging);
    const auto workplace = bench.workplace(0);
    const course::ExerciseResult result = course::judge_submission(
        *workplace, exercise, options.file, course::JudgeKind::grade,
        judging_seeds(options.judging.seed, options.judging.repeats,
                      course::read_file(options.file)));
    if (options.json)
        print_json(exercise, result);
    else
        print_text(exercise, result);
    return exit_code(result.verdict);
}

}  // namespace

void add_judge(CLI::App& program, int& code) {
    auto options = std::make_shared<JudgeOptions>();
    CLI::App* command =
        program.add_subcommand("judge", "Judge one file for one exercise");
    command->add_option("exercise", options->exercise, "name of the exercise")
        ->required();
    command->add_option("file", options->file, "the submitted file")
        ->required();
    command->add_flag("--json", options->json, "print one JSON object");
    options->judging.add_to(*command);
    command->footer(
        "Exit code: 0 accepted, 1 not accepted, 2 wrong usage, 3 grader "
        "fault.");
    command->callback([options, &code] { code = judge_command(*options); });
}

}  // namespace grader
