// A class that is judged on a cluster: jobs of Slurm, and a shared folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "grader/pipeline/executor.h"
#include "grader/pipeline/slurm_job.h"
#include "grader/pipeline/slurm_queue.h"

namespace grader {

struct SlurmOptions {
    std::size_t chunk = 0;  ///< tasks of a chunk; 0: chosen by their number
    /// How much later than its job's end a result may show in the folder.
    std::chrono::milliseconds grace{30'000};
    /// Told in words what the cluster does.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// Hands the tasks to a cluster and waits. What nodes that died or chunks that
/// were ended leave undone is handed out again, in smaller chunks, and so is
/// once what ended in a grader fault.
class SlurmExecutor : public Executor {
public:
    /// `folder` is for jobs, one executor at a time, and is seen by the nodes
    /// under the same path. It holds something after the end only where there
    /// is a reason: results of a head that was killed, which the next one takes
    /// over, or logs of chunks that gave none.
    SlurmExecutor(std::filesystem::path folder, const Conditions& conditions,
                  std::unique_ptr<Queue> queue, const SlurmOptions& options)
        : folder_(std::move(folder)),
          conditions_(conditions),
          queue_(std::move(queue)),
          options_(options) {}

    /// After stop(), the job is cancelled and the results that are there are
    /// handed over. What is without a result in the end is a grader fault.
    void judge(const Tasks& tasks, const TakeResult& take,
               const std::function<bool()>& stop) override;

private:
    std::filesystem::path folder_;
    Conditions conditions_;
    std::unique_ptr<Queue> queue_;
    SlurmOptions options_;
};

}  // namespace grader
