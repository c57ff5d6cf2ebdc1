#include "grader/pipeline/slurm_executor.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "grader/pipeline/keys.h"
#include "grader/pipeline/slurm_round.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::ExerciseResult;
using course::Verdict;

std::vector<JobFolder> job_folders(const fs::path& parent) {
    std::vector<JobFolder> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(parent, none))
        if (entry.path().filename().string().starts_with("grader-"))
            found.emplace_back(entry.path());
    return found;
}

bool is_alike(const Job& job, const Conditions& conditions) {
    try {
        return job.conditions == conditions &&
               job.build == build_version(exercises_of(job));
    } catch (const course::UnknownExercise&) {
        return false;
    }
}

/// What heads that were killed left in the folder.
class Leftovers {
public:
    explicit Leftovers(const SlurmWork& work) : work_(work) {}

    /// Ends their jobs, takes the results that are as good as new ones, removes
    /// the rest; the tasks that are still without one.
    std::vector<Pending> take();

private:
    /// Of a JobTask, and the limits of its exercise.
    using Source = std::tuple<std::string, std::string, course::Limits>;

    void take_from(const JobFolder& old);
    void take(const Source& source, const ExerciseResult& result);
    void list_tasks();

    const SlurmWork& work_;
    std::map<Source, std::vector<std::size_t>> wanted_;
};

void Leftovers::list_tasks() {
    for (std::size_t k = 0; k < work_.tasks.count; ++k) {
        const Task task = work_.tasks.at(k);
        wanted_[{task.exercise->full_name(), sha256(task.source),
                 task.exercise->limits}]
            .push_back(k);
    }
}

void Leftovers::take(const Source& source, const ExerciseResult& result) {
    const auto found = wanted_.find(source);
    if (found == wanted_.end() || result.verdict == Verdict::grader_fault)
        return;
    for (const std::size_t task : found->second) work_.take(task, result);
    wanted_.erase(found);
}

void Leftovers::take_from(const JobFolder& old) {
    const auto job = old.job();
    if (!job || !is_alike(*job, work_.conditions)) return;
    for (const std::size_t k : old.results()) {
        if (k >= job->tasks.size()) continue;
        const JobTask& listed = job->tasks[k];
        if (const auto result = old.result(k, listed))
            take({listed.exercise, listed.source,
                  limits_in(*job, listed.exercise)},
                 *result);
    }
}

std::vector<Pending> Leftovers::take() {
    list_tasks();
    for (const JobFolder& old : job_folders(work_.folder)) {
        work_.queue.cancel(old.name());
        take_from(old);
        old.remove();
    }
    std::vector<Pending> left;
    for (const auto& [source, tasks] : wanted_)
        for (const std::size_t task : tasks) left.push_back({task});
    std::sort(left.begin(), left.end(), [](const Pending& a, const Pending& b) {
        return a.task < b.task;
    });
    return left;
}

}  // namespace

void SlurmExecutor::judge(const Tasks& tasks, const TakeResult& take,
                          const std::function<bool()>& stop) {
    const SlurmWork work{folder_, conditions_, *queue_, options_,
                         tasks,   take,        stop};
    std::vector<Pending> left = Leftovers(work).take();
    for (int round = 1; round <= slurm_rounds && !left.empty() && !stop();
         ++round)
        left = SlurmRound(work, std::move(left), round).go();
}

}  // namespace grader
