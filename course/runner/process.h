// Other programs: started with exactly the descriptors that they are given,
// ended when their owner goes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "course/runner/descriptors.h"

namespace course {

/// What to start. Programs are searched in PATH; nothing passes a shell.
struct Command {
    std::vector<std::string> arguments;
    std::vector<std::string> environment;  ///< "NAME=value"
    /// Ours and the number that it gets there. Those of 0, 1 and 2 that are not
    /// named are /dev/null; no other descriptor is passed on.
    std::vector<std::pair<int, int>> descriptors;
    /// Where it runs, and all that it starts; where that cannot be had, nothing
    /// changes.
    std::optional<int> processor = std::nullopt;
};

/// PATH and the locale of this process: enough for compilers.
std::vector<std::string> plain_environment();

/// A running program. Its owner waits for it or ends it.
class Process {
public:
    /// Throws SystemError when it cannot be started.
    explicit Process(const Command& command);
    Process(Process&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}
    Process& operator=(Process&&) = delete;
    ~Process();

    /// Waits for the end; the status as from waitpid.
    int wait();

    /// Ends it at once; harmless when it has ended.
    void kill();

    /// Waits for its end, at most so long, and ends it then. A sandbox that
    /// ends by itself collects its own processes; one that is killed leaves
    /// that to the machine's first process, which in a container may never do
    /// it, and they count against the limit of processes.
    void end_within(std::chrono::milliseconds most);

private:
    void forget();

    pid_t pid_ = -1;
};

/// From now on, whatever kills this process, the programs that it has started
/// end with it, and all in their process groups. A program usually asks the
/// kernel for that itself, but may be killed between its own start and that of
/// its child. Precondition: no other thread runs. Throws SystemError.
void end_programs_with_this_process();

/// What a program printed, and how it ended.
struct Finished {
    int status = 0;          ///< as from waitpid
    bool timed_out = false;  ///< it was ended because its time was up
    std::string output;      ///< of 1 and 2, the middle cut out when long
};

/// Runs a program to its end, for at most `most`; keeps at most `most_bytes` of
/// what it prints, and reads the rest away. Throws SystemError.
Finished run(Command command, std::chrono::milliseconds most,
             std::size_t most_bytes);

}  // namespace course
