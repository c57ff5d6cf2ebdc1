#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "grader/cli/commands.h"

namespace grader {

void JudgingOptions::add_to(CLI::App& app) {
    app.add_option(
           "--jobs", jobs,
           "submissions judged at the same time (default: one per core)")
        ->check(CLI::Range(1, 64));
    app.add_option("--seed", seed,
                   "seed of renumbered and generated meshes (default 1)");
    app.add_flag("--without-sandbox", without_sandbox,
                 "judge although this machine offers no isolation: only for "
                 "submissions that you trust");
}

Bench::Bench(const JudgingOptions& options)
    : isolation_(Isolation::none),
      jobs_(options.jobs > 0
                ? options.jobs
                : std::clamp(
                      static_cast<int>(std::thread::hardware_concurrency()), 1,
                      64)) {
    if (options.without_sandbox) return;
    const Probe tried = probe(stage_);
    if (tried.isolation == Isolation::none)
        throw CannotBegin(fmt::format(
            "this machine offers no isolation for submissions: {}\nNothing was "
            "judged. With --without-sandbox submissions are run as your own "
            "user: only if you trust all of them.",
            tried.reason));
    isolation_ = tried.isolation;
}

std::string Bench::isolation_text() const {
    return isolation_ == Isolation::bubblewrap
               ? "bubblewrap: namespaces, system-call filter, limits"
               : "none: limits only";
}

std::unique_ptr<course::Workplace> Bench::workplace(int lane) const {
    return grader::workplace(isolation_, stage_, lane);
}

}  // namespace grader
