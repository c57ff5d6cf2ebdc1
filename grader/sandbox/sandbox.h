// Where submissions are compiled and run: under bubblewrap, as an unprivileged
// user of their own, with nothing of the machine but what the step needs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "course/runner/judge_submission.h"
#include "course/runner/temporary_folder.h"

namespace grader {

/// How submissions are kept apart from this machine.
enum class Isolation {
    bubblewrap,  ///< namespaces, system-call filters, limits
    none,        ///< limits only; must be asked for by name
};

/// Which isolation this machine offers, and the reason when it is none.
struct Probe {
    Isolation isolation = Isolation::none;
    std::string reason;
};

/// What all sandboxes of a run share: the worker, the headers and the filters,
/// copied to where an unprivileged user can read them.
class Stage {
public:
    /// Throws SystemError.
    Stage();

    std::filesystem::path worker() const { return folder_ / "worker"; }
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

private:
    course::TemporaryFolder folder_;
    std::vector<std::string> libraries_;
    course::Descriptor user_lock_;
    int first_user_ = 0;
};

/// Tries a sandbox once.
Probe probe(const Stage& stage);

/// One lane of the grader: one submission at a time, under a user number of
/// its own when the grader runs as root.
class Sandbox : public course::Workplace {
public:
    Sandbox(const Stage& stage, int slot) : stage_(stage), slot_(slot) {}

    course::Compiled compile(const course::Exercise& exercise,
                             const std::filesystem::path& source,
                             const std::filesystem::path& shared) override;
    course::Process launch(const std::filesystem::path& shared,
                           const course::Descriptor& control,
                           const course::Descriptor& complaints) override;

private:
    const Stage& stage_;
    int slot_;
};

/// The workplace of a lane.
std::unique_ptr<course::Workplace> workplace(Isolation isolation,
                                             const Stage& stage, int slot);

}  // namespace grader
