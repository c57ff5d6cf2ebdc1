// Who judges the files of a class: the lanes of this machine, or a cluster.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "course/runner/exercises.h"
#include "course/runner/judge_submission.h"
#include "course/runner/results.h"

namespace grader {

/// One file that has to be judged.
struct Task {
    const course::Exercise* exercise;
    std::string source;  ///< all its bytes
};

/// All files that have to be judged. They are made one by one when their turn
/// comes: those of a class may be more than a machine has memory.
struct Tasks {
    std::size_t count = 0;
    std::function<Task(std::size_t)> at;  ///< from any thread
};

/// How each of them is judged.
struct Judging {
    std::uint64_t seed = 1;
    int repeats = 2;  ///< how often each case is run
};

/// What to do with a result; never called for two at the same time.
using TakeResult =
    std::function<void(std::size_t task, const course::ExerciseResult&)>;

class Executor {
public:
    virtual ~Executor() = default;

    /// Judges the tasks, begun in their order, and hands over each result when
    /// it is there. Returns when all are done or, soon after stop() has become
    /// true, without the rest. What goes wrong with one task is its grader
    /// fault; throws SystemError when nothing can be judged at all, and what
    /// `take` throws.
    virtual void judge(const Tasks& tasks, const TakeResult& take,
                       const std::function<bool()>& stop) = 0;
};

/// Makes the workplace of a lane, 0 <= lane < jobs; for any thread.
using WorkplaceMaker =
    std::function<std::unique_ptr<course::Workplace>(int lane)>;

/// This machine, with so many lanes. A task that waits for a lane holds nobody
/// up: one that runs into its limits occupies one lane only.
class LocalExecutor : public Executor {
public:
    LocalExecutor(int jobs, const Judging& judging, WorkplaceMaker workplaces)
        : jobs_(jobs), judging_(judging), workplaces_(std::move(workplaces)) {}

    void judge(const Tasks& tasks, const TakeResult& take,
               const std::function<bool()>& stop) override;

private:
    int jobs_;
    Judging judging_;
    WorkplaceMaker workplaces_;
};

}  // namespace grader
