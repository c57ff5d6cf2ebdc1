#include "grader/pipeline/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "course/runner/pool.h"
#include "course/runner/statement.h"
#include "grader/pipeline/keys.h"
#include "grader/pipeline/wrong_submissions.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::ExerciseResult;
using course::Verdict;
using course::Visibility;

constexpr int fewest_hints = 3;
constexpr int fewest_wrong = 5;

enum class Role { reference_in_process, reference, skeleton, wrong };

/// One file to judge, and what must come of it.
struct Trial {
    std::size_t exercise;  ///< index into the validations
    Role role;
    fs::path file;
    Verdict expected = Verdict::accepted;
    std::uint64_t seed = 1;  ///< in process only
    ExerciseResult result{};
};

/// Stored wrong submissions: the name of the folder is the verdict.
void add_wrong(std::size_t index, const course::Exercise& exercise,
               std::vector<Trial>& trials,
               std::vector<std::string>& complaints) {
    const WrongSubmissions stored = wrong_submissions(exercise);
    for (const WrongSubmission& one : stored.all)
        trials.push_back({index, Role::wrong, one.file, one.verdict});
    for (const fs::path& file : stored.strays)
        complaints.push_back(fmt::format(
            "{}: expected a folder named after a verdict and a file {}",
            fs::relative(file, course::source_root()).string(),
            "*" + exercise.skeleton().extension().string()));
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos;
         at = text.find(word, at + word.size()))
        ++n;
    return n;
}

/// What can be said without running anything.
void look_at_files(Validation& validation) {
    const course::Exercise& exercise = validation.exercise;
    const auto complain = [&](std::string text) {
        validation.complaints.push_back(std::move(text));
    };
    for (const fs::path& file :
         {exercise.skeleton(), exercise.statement(), exercise.solution()})
        if (!fs::exists(file))
            complain("there is no " +
                     fs::relative(file, course::source_root()).string());
    if (!validation.complaints.empty()) return;
    if (const auto hints = course::statement_of(exercise).hints.size();
        hints < fewest_hints)
        complain(fmt::format("{} hints in {}.md, expected at least {}", hints,
                             exercise.name, fewest_hints));
    const auto todo =
        count(course::read_file(exercise.skeleton()), "TODO(student):");
    if (!exercise.is_data && todo != 1)
        complain(
            fmt::format("the skeleton has {} TODO(student): lines, "
                        "expected 1",
                        todo));
}

/// Every `every`-th of the trials from `first` on, by turns with the exercise.
void thin_out(std::vector<Trial>& trials, std::size_t first, int every) {
    std::size_t kept = first;
    const auto step = static_cast<std::size_t>(every);
    for (std::size_t k = first; k < trials.size(); ++k)
        if ((k - first + trials[k].exercise) % step == 0)
            trials[kept++] = trials[k];
    trials.resize(kept);
}

std::vector<Trial> trials_of(std::size_t index, Validation& validation,
                             int every) {
    std::vector<Trial> trials;
    const course::Exercise& exercise = validation.exercise;
    look_at_files(validation);
    if (!validation.complaints.empty()) return trials;
    const fs::path solution = exercise.solution();
    // Each submission is judged with seeds of its own: the suite must be right
    // with any. The first few stand for them.
    constexpr std::uint64_t seeds = 8;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        trials.push_back({index, Role::reference_in_process, solution,
                          Verdict::accepted, seed});
    trials.push_back({index, Role::reference, solution});
    trials.push_back({index, Role::skeleton, exercise.skeleton()});
    const std::size_t others = trials.size();
    add_wrong(index, exercise, trials, validation.complaints);
    const auto stored = static_cast<int>(trials.size() - others);
    if (stored < fewest_wrong)
        validation.complaints.push_back(
            fmt::format("{} stored wrong submissions, expected at least {}",
                        stored, fewest_wrong));
    thin_out(trials, others, every);
    validation.wrong = static_cast<int>(trials.size() - others);
    return trials;
}

ExerciseResult in_process(const Trial& trial,
                          const course::Exercise& exercise) {
    course::JudgeRun run;
    run.exercise = exercise;
    run.kind = course::JudgeKind::reference;
    run.seeds = {trial.seed};
    if (exercise.is_data) run.submitted = trial.file;
    return course::RunningJudge(run).result();
}

ExerciseResult carry_out(const Trial& trial, const ValidationRun& run,
                         course::Workplace& workplace) {
    const course::Exercise& exercise = run.exercises[trial.exercise];
    if (trial.role == Role::reference_in_process)
        return in_process(trial, exercise);
    return course::judge_submission(
        workplace, exercise, trial.file, course::JudgeKind::grade,
        judging_seeds(run.seed, run.repeats, course::read_file(trial.file)));
}

/// The first thing that went wrong, in one line.
std::string first_trouble(const ExerciseResult& result) {
    for (const auto& c : result.cases) {
        if (c.verdict == Verdict::accepted) continue;
        std::string text = fmt::format("\"{}\"", c.info.name);
        if (!c.failures.empty())
            text += fmt::format(": {} gave {}, expected {}", c.failures[0].call,
                                c.failures[0].got, c.failures[0].expected);
        return text;
    }
    return result.message.substr(0, 200);
}

void judge_reference(Validation& validation, const ExerciseResult& result,
                     const std::string& where) {
    if (result.verdict != Verdict::accepted)
        validation.complaints.push_back(
            fmt::format("the reference, {}: {}, expected accepted: {}", where,
                        words(result.verdict), first_trouble(result)));
}

void judge_cases(Validation& validation, const ExerciseResult& result) {
    validation.max = result.max();
    validation.cases = static_cast<int>(result.cases.size());
    for (const auto& c : result.cases) {
        if (c.hint.empty())
            validation.complaints.push_back(
                fmt::format("case \"{}\" has no hint", c.info.name));
        if (c.info.points <= 0)
            validation.complaints.push_back(
                fmt::format("case \"{}\" has no points", c.info.name));
    }
}

void judge_skeleton(Validation& validation, const ExerciseResult& result) {
    validation.skeleton = fmt::format("{} {:g}/{:g}", words(result.verdict),
                                      result.points(), result.max());
    if (result.verdict >= Verdict::compile_error)
        validation.complaints.push_back(
            fmt::format("the skeleton: {}, expected that it compiles and "
                        "fails: {}",
                        words(result.verdict), first_trouble(result)));
    for (const Visibility which : {Visibility::shown, Visibility::hidden}) {
        const bool passes = std::all_of(
            result.cases.begin(), result.cases.end(), [&](const auto& c) {
                return c.info.visibility != which ||
                       c.verdict == Verdict::accepted;
            });
        if (passes)
            validation.complaints.push_back(
                fmt::format("the skeleton passes the {} suite",
                            which == Visibility::shown ? "public" : "hidden"));
    }
}

/// Students read hints of wrong submissions, and of hidden cases nothing that
/// the assignment does not let them.
void look_at_hint(Validation& validation, const Trial& trial) {
    const std::string hint = mistake_text(course::read_file(trial.file)).hint;
    for (const auto& c : trial.result.cases)
        if (c.info.visibility == Visibility::hidden &&
            hint.find(c.info.name) != std::string::npos)
            validation.complaints.push_back(
                fmt::format("{}: its hint names the hidden case \"{}\"",
                            trial.file.filename().string(), c.info.name));
}

void judge_wrong(Validation& validation, const Trial& trial) {
    look_at_hint(validation, trial);
    if (trial.result.verdict == trial.expected) {
        ++validation.wrong_as_expected;
        return;
    }
    validation.complaints.push_back(
        fmt::format("{}: {}, expected {}: {}", trial.file.filename().string(),
                    words(trial.result.verdict), words(trial.expected),
                    first_trouble(trial.result)));
}

void conclude(Validation& validation, const Trial& trial) {
    switch (trial.role) {
        case Role::reference_in_process:
            return judge_reference(
                validation, trial.result,
                fmt::format("in process, seed {}", trial.seed));
        case Role::reference:
            judge_cases(validation, trial.result);
            return judge_reference(validation, trial.result, "in a worker");
        case Role::skeleton:
            return judge_skeleton(validation, trial.result);
        case Role::wrong:
            return judge_wrong(validation, trial);
    }
}

}  // namespace

std::vector<Validation> validate(
    const ValidationRun& run, const WorkplaceMaker& make_workplace,
    const std::function<void(int done, int all)>& progress) {
    const std::vector<course::Exercise>& exercises = run.exercises;
    std::vector<Validation> validations;
    std::vector<Trial> trials;
    for (std::size_t k = 0; k < exercises.size(); ++k) {
        validations.push_back({exercises[k]});
        for (Trial& trial : trials_of(k, validations.back(), run.every))
            trials.push_back(std::move(trial));
    }
    const int all = static_cast<int>(trials.size());
    std::atomic<int> done = 0;
    std::mutex guard;
    course::for_each_item(run.jobs, all, [&](int lane, int item) {
        Trial& trial = trials[static_cast<std::size_t>(item)];
        trial.result = carry_out(trial, run, *make_workplace(lane));
        const int now = ++done;
        const std::scoped_lock lock(guard);
        progress(now, all);
    });
    for (const Trial& trial : trials)
        conclude(validations[trial.exercise], trial);
    return validations;
}

}  // namespace grader
