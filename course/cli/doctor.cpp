// lab doctor: is this machine ready? The script has looked for compiler, CMake
// and packages before; here they are tried.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "course/cli/check.h"
#include "course/cli/commands.h"
#include "course/runner/compile.h"
#include "course/runner/judge_submission.h"
#include "course/runner/make_ready.h"
#include "course/runner/temporary_folder.h"

namespace course {

namespace {

/// What is tried, and what is wrong; nothing when it is well.
struct Trial {
    std::string what;
    std::string complaint;
};

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

Trial compiler_answers() {
    Command command;
    command.arguments = {compiler(), "--version"};
    command.environment = plain_environment();
    const Finished finished =
        run(std::move(command), std::chrono::seconds(20), 4096);
    if (finished.status == 0)
        return {"compiler: " + first_line(finished.output), ""};
    return {"compiler", fmt::format("{} does not run; remove {} and start "
                                    "again",
                                    compiler(), build_root().string())};
}

Trial suites_build(const Exercise& exercise) {
    try {
        make_ready({exercise}, {JudgeKind::lab});
    } catch (const std::exception& error) {
        return {"suites are built", error.what()};
    }
    return {"suites are built", ""};
}

/// A submission of ours gets the verdict that it deserves.
Trial gets(const Exercise& exercise, const std::string& body, Verdict verdict) {
    const std::string source = fmt::format(
        "#include \"exercises/{}.h\"\n"
        "int face_sides(const HalfEdgeTable& he, int i) {{ {} }}\n",
        exercise.full_name(), body);
    LocalWorkplace workplace;
    const ExerciseResult result =
        judge_source(workplace, exercise, source, JudgeKind::lab, {1});
    const std::string what =
        fmt::format("a program is judged: {}", words(verdict));
    if (result.verdict == verdict) return {what, ""};
    return {what,
            fmt::format("got {} {}", words(result.verdict), result.message)};
}

Trial can_be_written(const std::filesystem::path& folder) {
    const bool can = ::access(folder.c_str(), W_OK) == 0;
    return {fmt::format("{} can be written", folder.string()),
            can ? "" : "it cannot: whose is it?"};
}

int doctor(const Desk& desk) {
    // A copy for one assignment may be without the one that is tried here.
    const std::vector<Exercise> all = all_exercises();
    const auto found = std::find_if(
        all.begin(), all.end(),
        [](const Exercise& one) { return one.name == "face_sides"; });
    const Exercise exercise = found != all.end() ? *found : all.at(0);
    std::vector<Trial> trials = {compiler_answers(), suites_build(exercise)};
    if (trials.back().complaint.empty() && found != all.end())
        for (Trial& trial : std::vector<Trial>{
                 gets(exercise, "return he[i].vi - 99;", Verdict::wrong_answer),
                 gets(exercise, "for (;;) i = he[i].next;",
                      Verdict::time_limit_exceeded),
                 gets(exercise, "return he[0].nxt;", Verdict::compile_error)})
            trials.push_back(std::move(trial));
    trials.push_back(can_be_written(desk.root));
    int code = 0;
    for (const Trial& trial : trials) {
        fmt::print("{:<8}{}{}{}\n", trial.complaint.empty() ? "ok" : "WRONG",
                   trial.what, trial.complaint.empty() ? "" : ": ",
                   trial.complaint);
        if (!trial.complaint.empty()) code = 1;
    }
    fmt::print("{}", code == 0 ? "\nThis machine is ready.\n" : "");
    return code;
}

}  // namespace

void add_doctor(CLI::App& program, const Desk& desk, int& code) {
    CLI::App* command =
        program.add_subcommand("doctor", "Is this machine ready? Tries it.");
    command->footer("Exit code: 0 it is, 1 something is missing or wrong.");
    command->callback([&desk, &code] { code = doctor(desk); });
}

}  // namespace course
