// The folder of a job on a cluster, below one that all its machines share: the
// head writes sources and a list of tasks, the nodes a result for each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "course/runner/results.h"
#include "grader/pipeline/executor.h"
#include "grader/sandbox/sandbox.h"

namespace grader {

/// What results depend on beside their sources. A node must offer the same.
struct Conditions {
    std::uint64_t seed = 1;
    std::int32_t repeats = 2;
    Isolation isolation = Isolation::bubblewrap;
    std::string groups;  ///< control groups; empty where the head has none

    bool operator==(const Conditions&) const = default;
};

struct JobTask {
    std::string exercise;  ///< its full name
    std::string source;    ///< its hash
};

struct Job {
    Conditions conditions;
    std::string build;        ///< see build_version
    std::uint64_t chunk = 1;  ///< so many tasks are judged in one go
    std::vector<JobTask> tasks;
    std::map<std::string, course::Limits> limits;  ///< of its exercises

    std::size_t chunks() const { return (tasks.size() + chunk - 1) / chunk; }
};

/// Of an exercise of the job, by its full name.
course::Limits limits_in(const Job& job, const std::string& exercise);

/// The exercises of its tasks, each once, with their limits. Throws
/// course::UnknownExercise.
std::vector<course::Exercise> exercises_of(const Job& job);

/// Changes with this program, the suites, the worker, the headers that
/// submissions include, and the compiler. Reads all of them. Throws
/// course::SystemError when the build is not complete.
std::string build_version(const std::vector<course::Exercise>& exercises);

/// Tasks are numbered as in the job's list. A file gets its name only when it
/// is whole; its hash stands in it, as a machine that dies may still leave
/// rubbish. Writing throws course::SystemError.
class JobFolder {
public:
    explicit JobFolder(std::filesystem::path path) : path_(std::move(path)) {}

    /// A new one in `parent`, which is made; readable by its owner only.
    static JobFolder make(const std::filesystem::path& parent);

    const std::filesystem::path& path() const { return path_; }
    std::string name() const { return path_.filename().string(); }

    void write_source(std::size_t task, const std::string& source) const;
    /// Comes last: from now on the folder has a job.
    void write(const Job& job) const;

    /// Nothing where none was written by a grader of this version.
    std::optional<Job> job() const;
    /// Throws course::SystemError when it is not what the list says.
    std::string source(std::size_t task, const JobTask& listed) const;

    void write_result(std::size_t task, const JobTask& listed,
                      const course::ExerciseResult& result) const;
    /// Nothing where there is none yet, or rubbish.
    std::optional<course::ExerciseResult> result(std::size_t task,
                                                 const JobTask& listed) const;
    /// Numbers under which the folder lists results, in no order. No name is
    /// asked for: over a network that could be answered from before.
    std::vector<std::size_t> results() const;

    /// The end of what a chunk and the cluster had to say about it.
    std::string log(std::size_t chunk) const;

    /// As far as the system lets us.
    void remove() const;

private:
    std::filesystem::path path_;
};

}  // namespace grader
