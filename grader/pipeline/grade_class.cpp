#include "grader/pipeline/grade_class.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <atomic>
#include <ctime>
#include <fstream>
#include <mutex>

#include "course/runner/judge_submission.h"
#include "course/runner/temporary_folder.h"
#include "grader/pipeline/keys.h"
#include "grader/pipeline/pool.h"

namespace grader {

namespace {

using course::Exercise;
using course::ExerciseResult;
using course::Verdict;

// A fault of ours may pass: a machine that was out of memory for a moment.
constexpr int tries = 3;

std::string now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::time(nullptr)));
}

/// One file that has to be judged.
struct Task {
    const Submission* submission;
    const Exercise* exercise;
    const SubmittedFile* file;
    std::string key;
};

ExerciseResult judge(const Task& task, course::Workplace& workplace,
                     const ClassRun& run) {
    const course::TemporaryFolder folder;
    const auto path = folder / task.exercise->file_name();
    std::ofstream out(path, std::ios::binary);
    out << task.file->bytes;
    out.close();
    if (!out) throw course::SystemError("cannot write " + path.string());
    const auto seeds = judging_seeds(run.seed, run.repeats, task.file->bytes);
    ExerciseResult result;
    for (int k = 0; k < tries; ++k) {
        result = course::judge_submission(workplace, *task.exercise, path,
                                          course::JudgeKind::grade, seeds);
        if (result.verdict != Verdict::grader_fault) break;
    }
    return result;
}

class Grading {
public:
    Grading(const ClassRun& run, Gradebook& gradebook)
        : run_(run),
          gradebook_(gradebook),
          keys_(run.exercises, fmt::format("seed {}, {} times, {}", run.seed,
                                           run.repeats, run.isolation)) {}

    ClassRunResult go(const WorkplaceMaker& make_workplace,
                      const std::function<void(const Progress&)>& progress,
                      const std::function<bool()>& stop);

private:
    void begin();
    void look_at(const Submission& submission);
    void note_missing(const Submission& submission, const Exercise& exercise);
    void record(const Task& task, const ExerciseResult& result);

    const ClassRun& run_;
    Gradebook& gradebook_;
    Keys keys_;
    int number_ = 0;  ///< of the run in the gradebook
    std::vector<Task> tasks_;
    ClassRunResult result_;
};

void Grading::begin() {
    Run facts;
    facts.started_at = now();
    facts.version = COURSE_VERSION;
    facts.sandbox = run_.isolation;
    facts.seed = run_.seed;
    facts.jobs = run_.jobs;
    facts.notes = run_.submitted.notes;
    for (const Exercise& exercise : run_.exercises)
        facts.suites.push_back({exercise.full_name(), exercise.file_name(),
                                keys_.suite_version(exercise),
                                course::planned_points(exercise)});
    for (const Submission& submission : run_.submitted.submissions)
        facts.students.push_back(
            {submission.id, submission.student, submission.notes});
    number_ = gradebook_.begin_run(facts);
}

void Grading::note_missing(const Submission& submission,
                           const Exercise& exercise) {
    const std::string name = exercise.full_name();
    const std::string key = "not submitted";
    if (gradebook_.reuse(number_, submission.id, name, key)) return;
    ExerciseResult missing;
    missing.verdict = Verdict::not_submitted;
    gradebook_.record(number_, {submission.id, name, key, missing, now()});
}

void Grading::look_at(const Submission& submission) {
    for (const Exercise& exercise : run_.exercises) {
        const auto file = submission.files.find(exercise.file_name());
        if (file == submission.files.end()) {
            note_missing(submission, exercise);
            continue;
        }
        std::string key = keys_.of(exercise, file->second.bytes);
        if (gradebook_.reuse(number_, submission.id, exercise.full_name(), key))
            ++result_.unchanged;
        else
            tasks_.push_back({&submission, &exercise, &file->second, key});
    }
}

/// A database browser may hold the gradebook for a while, and results that
/// took hours must not be lost by that.
void record_patiently(Gradebook& gradebook, int run, const Attempt& attempt) {
    constexpr int most = 20;  // each waits for some seconds
    for (int k = 1;; ++k) {
        try {
            return gradebook.record(run, attempt);
        } catch (const GradebookLocked&) {
            if (k == most) throw;
        }
    }
}

void Grading::record(const Task& task, const ExerciseResult& result) {
    record_patiently(gradebook_, number_,
                     {task.submission->id, task.exercise->full_name(), task.key,
                      result, now()});
    ++result_.judged;
    if (result.verdict == Verdict::grader_fault) ++result_.faults;
}

ClassRunResult Grading::go(const WorkplaceMaker& make_workplace,
                           const std::function<void(const Progress&)>& progress,
                           const std::function<bool()>& stop) {
    begin();
    for (const Submission& submission : run_.submitted.submissions)
        if (run_.only.empty() || run_.only == submission.id ||
            run_.only == submission.student)
            look_at(submission);
    const int all = static_cast<int>(tasks_.size());
    std::mutex guard;
    for_each_item(
        run_.jobs, all,
        [&](int lane, int item) {
            const Task& task = tasks_[static_cast<std::size_t>(item)];
            const ExerciseResult result =
                judge(task, *make_workplace(lane), run_);
            const std::scoped_lock lock(guard);
            record(task, result);
            progress({result_.judged, all, result_.faults});
        },
        stop);
    result_.stopped = result_.judged < all;
    return result_;
}

}  // namespace

ClassRunResult grade_class(const ClassRun& run, Gradebook& gradebook,
                           const WorkplaceMaker& make_workplace,
                           const std::function<void(const Progress&)>& progress,
                           const std::function<bool()>& stop) {
    return Grading(run, gradebook).go(make_workplace, progress, stop);
}

}  // namespace grader
