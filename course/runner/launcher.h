// Starts and ends workers on order of the judge: the first process of a
// sandbox, and trusted. It never loads a submission itself.
#pragma once

#include <string>

namespace course {

struct LauncherOptions {
    std::string submission;  ///< path of the shared object, seen from here
    int control = 3;         ///< descriptor of the conversation with the judge

    /// Called in each worker before the submission is loaded; takes away what
    /// a worker may not do. Null: nothing beyond the limits.
    void (*lock_down)() = nullptr;
};

/// Serves orders until the judge closes the control channel; returns the exit
/// code of the process. Each worker is a fork of this one: the standard
/// library is already loaded, so a worker costs well below a millisecond.
int run_launcher(const LauncherOptions& options);

/// In a worker: loads the submission and answers requests on `channel` until
/// it is closed.
void serve_calls(const std::string& submission, int channel);

}  // namespace course
