// Checks an exercise again whenever its file is saved.
#pragma once

#include <poll.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "course/cli/background_run.h"
#include "course/cli/desk.h"
#include "course/cli/file_watch.h"

namespace course {

/// What came out of a check: the words of explain_result, and the exit code.
struct CheckOutcome {
    std::string text;
    int code = 0;
};

/// The suite is built first, and never given up. Then the newest save counts: a
/// check that a save overtakes is given up, and saves in quick succession are
/// waited out.
class Rechecker {
public:
    /// The first check begins at once.
    Rechecker(const Desk& desk, const Exercise& exercise);

    /// What has to be polled, and how long at most, before the next step.
    std::vector<pollfd> waits_for() const;
    std::chrono::milliseconds patience() const;

    /// Begins, gives up or ends what is due: true when an outcome is new.
    bool step();

    bool is_running() const { return run_.has_value(); }
    bool is_building() const { return run_ && !is_ready_; }
    const std::optional<CheckOutcome>& outcome() const { return outcome_; }
    const Exercise& exercise() const { return exercise_; }

private:
    void begin();

    const Desk& desk_;
    Exercise exercise_;
    FileWatch watch_;
    std::optional<Clock::time_point> due_;
    std::optional<BackgroundRun> run_;
    std::optional<CheckOutcome> outcome_;
    bool is_ready_ = false;  ///< the suite is built
};

/// Waits for what a rechecker waits for and for more descriptors; those that
/// have input. A signal ends it early.
std::vector<int> wait_for(std::vector<pollfd> list,
                          std::chrono::milliseconds most);

}  // namespace course
