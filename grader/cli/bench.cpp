#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "course/report/text.h"
#include "course/runner/pool.h"
#include "grader/cli/commands.h"

namespace grader {

namespace {

const std::map<std::string, Isolation> modes = {
    {"bubblewrap", Isolation::bubblewrap},
    {"landlock", Isolation::landlock},
    {"none", Isolation::none}};

/// The isolation to judge under; says why it is not the strongest.
Isolation isolation_for(const JudgingOptions& options, const Stage& stage) {
    if (options.isolation) {
        if (const auto reason = why_not(stage, *options.isolation))
            throw CannotBegin(
                fmt::format("this machine does not offer --isolation {}: "
                            "{}\nNothing was judged.",
                            name(*options.isolation), *reason));
        return *options.isolation;
    }
    const Probe tried = probe(stage);
    if (tried.isolation == Isolation::none)
        throw CannotBegin(fmt::format(
            "this machine offers no isolation for submissions: {}\nNothing was "
            "judged. With --isolation none submissions are run as your own "
            "user: only if you trust all of them.",
            tried.reason));
    if (!tried.reason.empty())
        fmt::print(stderr, "Isolation is not the strongest: {}\n",
                   course::visible(tried.reason));
    return tried.isolation;
}

}  // namespace

void JudgingOptions::add_to(CLI::App& app) {
    app.add_option(
           "--jobs", jobs,
           "submissions judged at the same time (default: one per core)")
        ->check(CLI::Range(1, 64));
    app.add_option("--seed", seed,
                   "seed of renumbered and generated meshes (default 1)");
    app.add_option("--repeats", repeats,
                   "how often each case is run, in fresh processes and on "
                   "meshes numbered in another way; it must pass each time "
                   "(default 2)")
        ->check(CLI::Range(1, 20));
    app.add_option("--isolation", isolation,
                   "bubblewrap, landlock, or none (default: the strongest that "
                   "this machine offers). none: your own user, only for "
                   "submissions that you trust")
        ->transform(CLI::CheckedTransformer(modes));
}

Bench::Bench(const JudgingOptions& options)
    : isolation_(isolation_for(options, stage_)),
      jobs_(options.jobs > 0 ? options.jobs
                             : std::min(course::core_count(), 64)) {}

std::string Bench::isolation_text() const {
    if (isolation_ == Isolation::none) return std::string(words(isolation_));
    return fmt::format("{}; {}", words(isolation_), stage_.groups().text());
}

std::unique_ptr<course::Workplace> Bench::workplace(int lane) const {
    return grader::workplace(isolation_, stage_, lane);
}

}  // namespace grader
