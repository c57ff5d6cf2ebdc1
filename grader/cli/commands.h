// The commands of the grader. Each gives the exit code of the process.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/pipeline/executor.h"
#include "grader/sandbox/sandbox.h"

namespace grader {

/// Options that every command has which judges submissions.
struct JudgingOptions {
    int jobs = 0;  ///< 0: one per core
    std::uint64_t seed = 1;
    int repeats = 2;                     ///< how often each case is judged
    std::optional<Isolation> isolation;  ///< none: the strongest there is

    void add_to(CLI::App& app);
};

/// Thrown when a command cannot begin; the message says why. Exit code 2.
struct CannotBegin : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What commands that judge have in common: isolation that was probed, lanes.
/// Says on the error stream which isolation holds, and why none better.
class Bench {
public:
    /// Throws CannotBegin when the isolation that was asked for is not to be
    /// had, or none at all is and that was not asked for by name.
    explicit Bench(const JudgingOptions& options);

    const Stage& stage() const { return stage_; }
    Isolation isolation() const { return isolation_; }
    int jobs() const { return jobs_; }
    std::string isolation_text() const;
    std::unique_ptr<course::Workplace> workplace(int lane) const;

private:
    Stage stage_;
    Isolation isolation_;
    int jobs_;
};

/// Options of a class's run: who judges.
struct ExecutorOptions {
    std::string name = "local";  ///< or "slurm", and then:
    std::size_t chunk = 0;       ///< 0: chosen
    std::string partition;
    std::string sbatch;  ///< arguments of it
    int grace = 30;      ///< seconds

    void add_to(CLI::App& app);
};

/// The executor; that of a cluster has its jobs below `out`. `bench` lives at
/// least as long.
std::unique_ptr<Executor> executor_for(const ExecutorOptions& options,
                                       const Bench& bench,
                                       const Judging& judging,
                                       const std::filesystem::path& out);

/// Adds the command to the program; `code` is set when it runs.
void add_run(CLI::App& program, int& code);
void add_regrade(CLI::App& program, int& code);
void add_judge(CLI::App& program, int& code);
void add_validate(CLI::App& program, int& code);
void add_show(CLI::App& program, int& code);
void add_history(CLI::App& program, int& code);
void add_diff(CLI::App& program, int& code);
void add_override(CLI::App& program, int& code);
void add_export(CLI::App& program, int& code);
void add_plagiarism(CLI::App& program, int& code);
void add_release(CLI::App& program, int& code);
void add_assignment(CLI::App& program, int& code);
void add_doctor(CLI::App& program, int& code);
void add_work(CLI::App& program, int& code);

}  // namespace grader
