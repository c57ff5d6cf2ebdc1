// From a submitted file to its result: compile, load in a worker, run a judge.
// Lab and grader differ in where the two steps that touch the file happen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/results.h"
#include "course/runner/run_judge.h"

namespace course {

/// How the compile step ended, and what the compiler said.
struct Compiled {
    Verdict verdict = Verdict::accepted;  ///< or compile_error, or grader_fault
    std::string messages;                 ///< warnings too
};

/// The place where submissions are compiled and run.
class Workplace {
public:
    virtual ~Workplace() = default;

    /// The processor for judge and worker: they talk to each other without
    /// end, and never at the same time. None: any.
    virtual std::optional<int> processor() const { return std::nullopt; }

    /// Compiles `source` and links it for its exercise into `shared`, after
    /// launch.
    virtual Compiled compile(const Exercise& exercise,
                             const std::filesystem::path& source,
                             const std::filesystem::path& shared) = 0;

    /// Starts a launcher for `shared`, which compile is going to make, whose
    /// workers have these limits; with the other end of its conversation with
    /// the judge, and a file for what it has to complain about. Throws
    /// SystemError.
    virtual Process launch(const std::filesystem::path& shared,
                           const Limits& limits, const Descriptor& control,
                           const Descriptor& complaints) = 0;
};

/// This machine as it is: limits as in grading, no isolation. For lab.
class LocalWorkplace : public Workplace {
public:
    Compiled compile(const Exercise& exercise,
                     const std::filesystem::path& source,
                     const std::filesystem::path& shared) override;
    Process launch(const std::filesystem::path& shared, const Limits& limits,
                   const Descriptor& control,
                   const Descriptor& complaints) override;
};

/// Judges one file, once for each seed (see JudgeRun). What goes wrong on our
/// side is a grader fault with the reason as its message; nothing is thrown.
ExerciseResult judge_submission(Workplace& workplace, const Exercise& exercise,
                                const std::filesystem::path& file,
                                JudgeKind kind,
                                const std::vector<std::uint64_t>& seeds);

/// The same for a file that is in memory.
ExerciseResult judge_source(Workplace& workplace, const Exercise& exercise,
                            const std::string& source, JudgeKind kind,
                            const std::vector<std::uint64_t>& seeds);

/// The compile step's end as lab and grader understand it: `linked` has the
/// output of the compiler.
Compiled compiled_from(const Finished& finished,
                       std::chrono::milliseconds patience);

}  // namespace course
