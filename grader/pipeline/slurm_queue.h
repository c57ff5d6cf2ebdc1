// What the head of a class on a cluster asks of the cluster.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace grader {

struct QueueState {
    enum class Kind {
        unknown,  ///< the cluster does not answer just now
        gone,     ///< nothing of the job runs or will run
        waiting,
        running,
    };
    Kind kind = Kind::unknown;
    std::string reason;  ///< why it waits
};

/// A job is an array of chunks, known by the name of its folder.
class Queue {
public:
    virtual ~Queue() = default;

    /// The most chunks that a job may have. Throws course::SystemError.
    virtual std::size_t most_chunks() = 0;

    /// Has chunks 0 to `chunks` - 1 of the folder's job judged. Throws
    /// course::SystemError with the cluster's words when it refuses.
    virtual void submit(const std::filesystem::path& folder,
                        std::size_t chunks) = 0;

    virtual QueueState state(const std::string& name) = 0;

    /// Nothing of it runs soon after. Harmless when there is no such job.
    virtual void cancel(const std::string& name) = 0;
};

/// Slurm, by its commands, without its accounting.
class SlurmQueue : public Queue {
public:
    /// `arguments` are those of sbatch, beside ours.
    explicit SlurmQueue(std::vector<std::string> arguments)
        : arguments_(std::move(arguments)) {}

    std::size_t most_chunks() override;
    void submit(const std::filesystem::path& folder,
                std::size_t chunks) override;
    QueueState state(const std::string& name) override;
    void cancel(const std::string& name) override;

private:
    std::vector<std::string> arguments_;
};

}  // namespace grader
