// What the commands have in common that grade a class into a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "course/runner/descriptors.h"
#include "grader/cli/commands.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/assignment.h"
#include "grader/pipeline/grade_class.h"

namespace grader {

/// The assignment that the file describes; none without a file. Throws
/// CannotBegin with every mistake in it.
std::optional<Assignment> assignment_in(const std::filesystem::path& file);

struct ClassOptions {
    std::filesystem::path dir;
    std::filesystem::path out;
    std::filesystem::path assignment;
    std::string only;
    std::string platform;      ///< empty: recognised
    std::string times;         ///< "files", or a table of times; or empty
    bool no_mistakes = false;  ///< recognise none
    JudgingOptions judging;
    ExecutorOptions executor;

    void add_to(CLI::App& app);
};

/// What was handed in of the exercises. Throws CannotBegin.
SubmittedClass submissions_of(const ClassOptions& options,
                              const std::vector<course::Exercise>& exercises);

/// A class and the folder with its gradebook, which nobody else grades into as
/// long as this lives.
class ClassSession {
public:
    /// Reads the class. Throws CannotBegin.
    explicit ClassSession(const ClassOptions& options);

    /// Judges what has no result yet; see Run::proposed. Says on the error
    /// stream how far it is. On Ctrl-C the submissions at work are finished
    /// and the rest is left; a second one ends the process at once, and loses
    /// these few.
    ClassRunResult grade(bool propose);

    const Assignment& assignment() const { return assignment_; }
    const SubmittedClass& submitted() const { return run_.submitted; }
    Gradebook& gradebook() { return gradebook_; }

private:
    ClassRunResult grade_judging(const std::function<bool()>& stop);

    std::optional<Assignment> chosen_;  ///< by the instructor
    ClassRun run_;
    Assignment assignment_;
    Bench bench_;
    course::Descriptor lock_;
    Gradebook gradebook_;
    std::unique_ptr<Executor> executor_;
    bool no_mistakes_;
};

}  // namespace grader
