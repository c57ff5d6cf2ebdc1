#include "grader/pipeline/slurm_chunk.h"

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <thread>

namespace grader {

namespace {

using course::Clock;
using course::Exercise;
using course::ExerciseResult;

class Chunk {
public:
    Chunk(const JobFolder& folder, const Job& job, std::size_t number,
          const std::function<bool()>& disturbed)
        : folder_(folder), job_(job), disturbed_(disturbed) {
        for (Exercise& exercise : exercises_of(job)) {
            std::string name = exercise.full_name();
            exercises_.emplace(std::move(name), std::move(exercise));
        }
        const std::size_t first = number * job.chunk;
        const std::size_t end = std::min(first + job.chunk, job.tasks.size());
        for (std::size_t task = first; task < end; ++task)
            if (!folder.result(task, job.tasks[task])) todo_.push_back(task);
    }

    bool judge(Executor& executor);

private:
    struct Held {
        Clock::time_point since;
        std::size_t task;
        ExerciseResult result;
    };

    Task task(std::size_t number) const {
        const JobTask& listed = job_.tasks[number];
        return {&exercises_.at(listed.exercise),
                folder_.source(number, listed)};
    }
    void write_settled();

    const JobFolder& folder_;
    const Job& job_;
    const std::function<bool()>& disturbed_;
    std::map<std::string, Exercise> exercises_;
    std::vector<std::size_t> todo_;
    std::deque<Held> held_;
    std::size_t written_ = 0;
};

void Chunk::write_settled() {
    const auto now = Clock::now();
    // Asked after the clock: whatever happened before that is known here.
    if (disturbed_()) return held_.clear();
    for (; !held_.empty() && held_.front().since + settling_time <= now;
         held_.pop_front(), ++written_)
        folder_.write_result(held_.front().task, job_.tasks[held_.front().task],
                             held_.front().result);
}

bool Chunk::judge(Executor& executor) {
    const Tasks tasks{todo_.size(),
                      [&](std::size_t k) { return task(todo_[k]); }};
    executor.judge(
        tasks,
        [&](std::size_t k, const ExerciseResult& result) {
            held_.push_back({Clock::now(), todo_[k], result});
            write_settled();
        },
        disturbed_);
    for (; !held_.empty(); write_settled())
        std::this_thread::sleep_for(settling_time / 20);
    return written_ == todo_.size();
}

}  // namespace

bool judge_chunk(const JobFolder& folder, const Job& job, std::size_t chunk,
                 Executor& executor, const std::function<bool()>& disturbed) {
    return Chunk(folder, job, chunk, disturbed).judge(executor);
}

}  // namespace grader
