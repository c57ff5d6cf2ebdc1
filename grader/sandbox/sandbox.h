// Where submissions are compiled and run: apart from this machine, as an
// unprivileged user, with nothing but what the step needs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/judge_submission.h"
#include "course/runner/temporary_folder.h"
#include "grader/sandbox/control_group.h"

namespace grader {

/// How submissions are kept apart from this machine, strongest first.
enum class Isolation {
    bubblewrap,  ///< namespaces, system-call filters, limits
    landlock,    ///< Landlock, system-call filters, limits; as root also a user
                 ///< and a root folder of their own
    none,        ///< limits only; must be asked for by name
};

/// "bubblewrap", "landlock", "none".
std::string_view name(Isolation isolation);

/// What it consists of, in one line for people.
std::string_view words(Isolation isolation);

/// What all sandboxes of a run share: the worker, the headers and the filters,
/// copied to where an unprivileged user can read them.
class Stage {
public:
    /// Throws SystemError.
    Stage();

    /// Root folder of a run step: the worker, and its libraries where it is
    /// that of the process as well.
    std::filesystem::path root() const { return folder_ / "root"; }
    std::filesystem::path worker() const { return root() / "worker"; }
    std::filesystem::path enter() const { return folder_ / "enter"; }
    std::filesystem::path student() const { return folder_ / "student"; }
    std::filesystem::path compile_filter() const {
        return folder_ / "compile.bpf";
    }
    std::filesystem::path worker_filter() const {
        return folder_ / "worker.bpf";
    }
    /// The first of the user numbers that this run may use when it is root;
    /// no other grader on this machine uses them at the same time.
    int first_user() const { return first_user_; }

    /// Shared libraries of the worker, and its loader.
    const std::vector<std::string>& libraries() const { return libraries_; }

    const ControlGroups& groups() const { return groups_; }

private:
    course::TemporaryFolder folder_;
    std::vector<std::string> libraries_;
    course::Descriptor user_lock_;
    int first_user_ = 0;
    ControlGroups groups_;
};

/// Tries an isolation once; the reason why this machine does not offer it, or
/// nothing when it does.
std::optional<std::string> why_not(const Stage& stage, Isolation isolation);

/// The strongest isolation that this machine offers, and why no stronger one.
struct Probe {
    Isolation isolation = Isolation::none;
    std::string reason;
};
Probe probe(const Stage& stage);

/// What one step may use; 0: no limit here.
struct StepLimits {
    int cpu_seconds;
    int process_mib;  ///< address space of each process
    int group_mib;    ///< memory of all together, where there are groups
    int file_mib;
    int processes;
};

/// One lane of the grader: one submission at a time, under a user number of
/// its own when the grader runs as root. Nothing of a step outlives it.
class Sandbox : public course::Workplace {
public:
    Sandbox(Isolation isolation, const Stage& stage, int slot)
        : isolation_(isolation), stage_(stage), slot_(slot) {}
    ~Sandbox() override;

    std::optional<int> processor() const override;
    course::Compiled compile(const course::Exercise& exercise,
                             const std::filesystem::path& source,
                             const std::filesystem::path& shared) override;
    course::Process launch(const std::filesystem::path& shared,
                           const course::Limits& limits,
                           const course::Descriptor& control,
                           const course::Descriptor& complaints) override;

private:
    void enter(course::Command& command, const char* step,
               const StepLimits& limits, std::optional<ControlGroup>& group);

    Isolation isolation_;
    const Stage& stage_;
    int slot_;
    std::optional<ControlGroup> group_;  ///< of the run step
};

/// The workplace of a lane.
std::unique_ptr<course::Workplace> workplace(Isolation isolation,
                                             const Stage& stage, int slot);

}  // namespace grader
