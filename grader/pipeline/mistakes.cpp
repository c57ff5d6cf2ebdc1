#include "grader/pipeline/mistakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "course/mesh/file_defects.h"
#include "course/report/explain.h"
#include "course/runner/codec.h"
#include "grader/pipeline/keys.h"
#include "grader/pipeline/wrong_submissions.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::Exercise;
using course::ExerciseResult;
using course::Verdict;

/// The fingerprints that this build has computed for an exercise, by the key of
/// the result. A line for each: key, blank, fingerprint.
class Kept {
public:
    explicit Kept(const Exercise& exercise)
        : file_(course::build_root() / "grader" / "mistakes" / exercise.name) {
        std::ifstream in(file_);
        for (std::string line; std::getline(in, line);)
            if (const auto blank = line.find(' '); blank != line.npos)
                known_[line.substr(0, blank)] = line.substr(blank + 1);
    }

    const std::string* find(const std::string& key) const {
        const auto found = known_.find(key);
        return found == known_.end() ? nullptr : &found->second;
    }

    void add(const std::string& key, const std::string& fingerprint) {
        known_[key] = fingerprint;
    }

    void write() const {
        fs::create_directories(file_.parent_path());
        std::string text;
        for (const auto& [key, fingerprint] : known_)
            text += fmt::format("{} {}\n", key, fingerprint);
        course::replace_text(file_, text);
    }

private:
    fs::path file_;
    std::map<std::string, std::string> known_;
};

/// A stored wrong submission that is wanted.
struct Wanted {
    std::size_t exercise;  ///< number in the run
    fs::path file;
    std::string source;
    std::string key;
};

class Learning {
public:
    Learning(const ClassRun& run, int number, Gradebook& gradebook)
        : run_(run),
          number_(number),
          gradebook_(gradebook),
          keys_(keys_of(run)) {
        for (const Exercise& exercise : run.exercises)
            kept_.emplace_back(exercise);
    }

    void list_wanted();
    void judge_new(Executor& executor,
                   const std::function<void(const std::string&)>& say,
                   const std::function<bool()>& stop);
    void keep(const std::function<void(const std::string&)>& say) const;
    void record();

private:
    void want(std::size_t exercise, const WrongSubmission& wrong);
    bool is_whole(std::size_t exercise) const;
    const std::string* fingerprint_of(const Wanted& wanted) const {
        return kept_[wanted.exercise].find(wanted.key);
    }

    const ClassRun& run_;
    int number_;
    Gradebook& gradebook_;
    Keys keys_;
    std::vector<Kept> kept_;  ///< by number of the exercise
    std::vector<Wanted> wanted_;
    std::vector<std::size_t> new_;  ///< numbers of those to be judged
};

void Learning::want(std::size_t exercise, const WrongSubmission& wrong) {
    std::string source = course::read_file(wrong.file);
    std::string key = keys_.of(run_.exercises[exercise], source);
    wanted_.push_back(
        {exercise, wrong.file, std::move(source), std::move(key)});
    if (fingerprint_of(wanted_.back()) == nullptr)
        new_.push_back(wanted_.size() - 1);
}

/// Those of the exercises and verdicts that partly failed submissions have.
void Learning::list_wanted() {
    const auto partly_failed = gradebook_.partly_failed(number_);
    for (std::size_t k = 0; k < run_.exercises.size(); ++k) {
        const Exercise& exercise = run_.exercises[k];
        for (const WrongSubmission& wrong : wrong_submissions(exercise).all)
            if (partly_failed.contains({exercise.full_name(), wrong.verdict}))
                want(k, wrong);
    }
}

void Learning::judge_new(Executor& executor,
                         const std::function<void(const std::string&)>& say,
                         const std::function<bool()>& stop) {
    if (new_.empty()) return;
    say(
        fmt::format("Judging {} stored wrong submissions, once for these "
                    "suites, to recognise mistakes.",
                    new_.size()));
    const Tasks tasks{
        new_.size(), [&](std::size_t k) {
            const Wanted& wanted = wanted_[new_[k]];
            return Task{&run_.exercises[wanted.exercise], wanted.source};
        }};
    const auto take = [&](std::size_t k, const ExerciseResult& result) {
        const Wanted& wanted = wanted_[new_[k]];
        if (result.verdict != Verdict::grader_fault)
            kept_[wanted.exercise].add(wanted.key, fingerprint(result));
    };
    executor.judge(tasks, take, stop);
}

void Learning::keep(const std::function<void(const std::string&)>& say) const {
    if (new_.empty()) return;
    try {
        for (const Kept& kept : kept_) kept.write();
    } catch (const std::exception& error) {
        say(fmt::format("{}; they will be judged again by the next run.",
                        error.what()));
    }
}

bool Learning::is_whole(std::size_t exercise) const {
    return std::all_of(wanted_.begin(), wanted_.end(), [&](const Wanted& one) {
        return one.exercise != exercise || fingerprint_of(one) != nullptr;
    });
}

void Learning::record() {
    std::vector<KnownMistake> known;
    for (const Wanted& wanted : wanted_) {
        const std::string* fingerprint = fingerprint_of(wanted);
        if (fingerprint == nullptr || fingerprint->empty() ||
            !is_whole(wanted.exercise))
            continue;
        const MistakeText text = mistake_text(wanted.source);
        known.push_back({run_.exercises[wanted.exercise].full_name(),
                         wanted.file.stem().string(), text.mistake, text.hint,
                         *fingerprint});
    }
    gradebook_.add_mistakes(number_, known);
}

}  // namespace

std::string fingerprint(const ExerciseResult& result) {
    const auto passed =
        std::count_if(result.cases.begin(), result.cases.end(),
                      [](const course::CaseResult& one) {
                          return one.verdict == Verdict::accepted;
                      });
    if (!course::has_run(result) || passed == 0 ||
        passed == std::ssize(result.cases))
        return "";
    std::vector<std::string> cases;
    for (const course::CaseResult& one : result.cases) {
        cases.push_back(one.info.name);
        cases.emplace_back(course::name(one.verdict));
    }
    return sha256(course::encode(cases));
}

void learn_mistakes(const ClassRun& run, int number, Gradebook& gradebook,
                    Executor& executor,
                    const std::function<void(const std::string&)>& say,
                    const std::function<bool()>& stop) {
    Learning learning(run, number, gradebook);
    learning.list_wanted();
    learning.judge_new(executor, say, stop);
    learning.keep(say);
    learning.record();
}

std::optional<RecognisedMistake> recognised(
    const std::vector<KnownMistake>& known, const std::string& exercise,
    const ExerciseResult& result) {
    const std::string wanted = fingerprint(result);
    if (wanted.empty()) return std::nullopt;
    std::optional<RecognisedMistake> found;
    for (const KnownMistake& one : known) {
        if (one.exercise != exercise || one.fingerprint != wanted) continue;
        if (found && (found->hint != one.hint || one.hint.empty()))
            return std::nullopt;
        if (!found) found = {one.mistake, one.hint};
    }
    return found;
}

}  // namespace grader
