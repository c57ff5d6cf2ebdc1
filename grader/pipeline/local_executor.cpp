#include <mutex>

#include "course/runner/pool.h"
#include "grader/pipeline/executor.h"
#include "grader/pipeline/keys.h"

namespace grader {

namespace {

using course::ExerciseResult;

// A fault of ours may pass: a machine that was out of memory for a moment.
constexpr int tries = 3;

ExerciseResult judge_one(const Task& task, const Judging& judging,
                         course::Workplace& workplace) {
    const auto seeds =
        judging_seeds(judging.seed, judging.repeats, task.source);
    ExerciseResult result;
    for (int k = 0; k < tries; ++k) {
        result = course::judge_source(workplace, *task.exercise, task.source,
                                      course::JudgeKind::grade, seeds);
        if (result.verdict != course::Verdict::grader_fault) break;
    }
    return result;
}

}  // namespace

void LocalExecutor::judge(const Tasks& tasks, const TakeResult& take,
                          const std::function<bool()>& stop) {
    std::mutex guard;
    course::for_each_item(
        jobs_, static_cast<int>(tasks.count),
        [&](int lane, int item) {
            const auto number = static_cast<std::size_t>(item);
            const ExerciseResult result =
                judge_one(tasks.at(number), judging_, *workplaces_(lane));
            const std::scoped_lock lock(guard);
            take(number, result);
        },
        stop);
}

}  // namespace grader
