// One job of a class on a cluster, from its tasks to what it left undone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/descriptors.h"
#include "grader/pipeline/slurm_executor.h"

namespace grader {

/// So many jobs are made, one after the other, before a task is given up.
constexpr int slurm_rounds = 3;

/// A task without a result, or with one that may not have been its own fault.
struct Pending {
    std::size_t task;
    bool was_fault = false;
};

/// What all rounds of one class have in common.
struct SlurmWork {
    const std::filesystem::path& folder;
    const Conditions& conditions;
    Queue& queue;
    const SlurmOptions& options;
    const Tasks& tasks;
    const TakeResult& take;
    const std::function<bool()>& stop;
};

class SlurmRound {
public:
    /// `number` counts from 1.
    SlurmRound(const SlurmWork& work, std::vector<Pending> tasks, int number);

    /// Writes the tasks to a new folder, hands them out, takes their results;
    /// those that have to be judged again. The last round gives these up, and
    /// leaves its folder for its logs. Throws course::SystemError, and what the
    /// taking throws; then results may still be in the folder.
    std::vector<Pending> go();

private:
    void write_tasks(std::size_t most_chunks);
    void submit();
    void watch();
    void look();
    void ask();
    void wait_for_end();
    void finish();
    void give_up();
    void say(const std::string& text);

    const SlurmWork& work_;
    std::vector<Pending> tasks_;
    int number_;
    JobFolder folder_;
    Job job_;
    std::vector<bool> seen_;
    std::size_t left_;
    std::vector<Pending> again_;
    std::optional<course::Clock::time_point> ended_;
    std::string said_;
};

}  // namespace grader
