#include "grader/pipeline/grade_class.h"

#include <fmt/format.h>

#include "grader/pipeline/who_and_when.h"

namespace grader {

namespace {

using course::Exercise;
using course::ExerciseResult;
using course::Verdict;

/// As the gradebook keeps them.
Student student_of(const Submission& submission) {
    Student student{submission.id, submission.student, submission.notes};
    student.person = submission.person;
    student.key = submission.key;
    if (submission.submitted_at)
        student.submitted_at = text_of(*submission.submitted_at);
    student.marked_late = submission.marked_late;
    student.members = submission.members;
    return student;
}

class Grading {
public:
    Grading(const ClassRun& run, Gradebook& gradebook)
        : run_(run), gradebook_(gradebook), keys_(keys_of(run)) {}

    ClassRunResult go(Executor& executor,
                      const std::function<void(const Progress&)>& progress,
                      const std::function<bool()>& stop);

private:
    /// One file of one student, by two numbers: thousands wait at a time.
    struct Place {
        std::uint32_t student, exercise;
    };

    void begin();
    bool is_meant(const Submission& submission) const;
    void look_at(std::uint32_t student);
    void look_at(const Place& place);
    const Submission& submission(const Place& place) const {
        return run_.submitted.submissions[place.student];
    }
    const Exercise& exercise(const Place& place) const {
        return run_.exercises[place.exercise];
    }
    std::string source(const Place& place) const {
        return run_.submitted.bytes(submission(place), place.exercise);
    }
    void note_missing(const Place& place);
    void record(const Place& place, const std::string& key,
                const ExerciseResult& result);

    const ClassRun& run_;
    Gradebook& gradebook_;
    Keys keys_;
    std::vector<Place> to_judge_;
    ClassRunResult result_;
    int failed_ = 0;
};

void Grading::begin() {
    Run facts;
    facts.started_at = utc_now();
    facts.version = COURSE_VERSION;
    facts.sandbox = run_.isolation;
    facts.seed = run_.judging.seed;
    facts.jobs = run_.jobs;
    facts.user = user_name();
    facts.notes = run_.submitted.notes;
    facts.proposed = run_.propose;
    for (const Exercise& exercise : run_.exercises)
        facts.suites.push_back({exercise.full_name(), exercise.file_name(),
                                keys_.suite_version(exercise),
                                course::planned_points(exercise)});
    for (const Submission& submission : run_.submitted.submissions)
        facts.students.push_back(student_of(submission));
    result_.run = gradebook_.begin_run(facts);
}

/// A database browser may hold the gradebook for a while, and results that
/// took hours must not be lost by that.
template <class Write>
void patiently(Write write) {
    constexpr int most = 20;  // each waits for some seconds
    for (int k = 1;; ++k) {
        try {
            return write();
        } catch (const GradebookLocked&) {
            if (k == most) throw;
        }
    }
}

void Grading::record(const Place& place, const std::string& key,
                     const ExerciseResult& result) {
    const bool is_there = submission(place).files[place.exercise].has_value();
    const Attempt attempt = {submission(place).id,
                             exercise(place).full_name(),
                             key,
                             result,
                             utc_now(),
                             is_there ? sha256(source(place)) : ""};
    patiently([&] { gradebook_.record(result_.run, attempt); });
}

void Grading::note_missing(const Place& place) {
    const std::string key = "not submitted";
    if (gradebook_.reuse(result_.run, submission(place).id,
                         exercise(place).full_name(), key))
        return;
    ExerciseResult missing;
    missing.verdict = Verdict::not_submitted;
    record(place, key, missing);
}

void Grading::look_at(const Place& place) {
    if (!submission(place).files[place.exercise]) return note_missing(place);
    const std::string key = keys_.of(exercise(place), source(place));
    if (gradebook_.reuse(result_.run, submission(place).id,
                         exercise(place).full_name(), key))
        ++result_.unchanged;
    else
        to_judge_.push_back(place);
}

bool Grading::is_meant(const Submission& submission) const {
    return run_.only.empty() || is_named(submission, run_.only);
}

void Grading::look_at(std::uint32_t student) {
    if (is_meant(run_.submitted.submissions[student]))
        for (std::uint32_t k = 0; k < run_.exercises.size(); ++k)
            look_at(Place{student, k});
}

ClassRunResult Grading::go(Executor& executor,
                           const std::function<void(const Progress&)>& progress,
                           const std::function<bool()>& stop) {
    begin();
    for (std::uint32_t k = 0; k < run_.submitted.submissions.size(); ++k)
        look_at(k);
    const Tasks tasks{
        to_judge_.size(), [&](std::size_t k) {
            return Task{&exercise(to_judge_[k]), source(to_judge_[k])};
        }};
    const auto take = [&](std::size_t k, const ExerciseResult& result) {
        const Place& place = to_judge_[k];
        record(place, keys_.of(exercise(place), source(place)), result);
        ++result_.judged;
        if (result.verdict == Verdict::grader_fault)
            ++result_.faults;
        else if (result.verdict != Verdict::accepted)
            ++failed_;
        progress({result_.judged, static_cast<int>(tasks.count), failed_,
                  result_.faults});
    };
    progress({0, static_cast<int>(tasks.count), 0, 0});
    executor.judge(tasks, take, stop);
    result_.stopped = static_cast<std::size_t>(result_.judged) < tasks.count;
    return result_;
}

}  // namespace

Keys keys_of(const ClassRun& run) {
    return {run.exercises,
            fmt::format("seed {}, {} times, {}", run.judging.seed,
                        run.judging.repeats, run.isolation)};
}

ClassRunResult grade_class(const ClassRun& run, Gradebook& gradebook,
                           Executor& executor,
                           const std::function<void(const Progress&)>& progress,
                           const std::function<bool()>& stop) {
    return Grading(run, gradebook).go(executor, progress, stop);
}

}  // namespace grader
