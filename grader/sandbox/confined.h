// Work on hostile bytes in a child process that can do nothing else.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "course/runner/descriptors.h"

namespace grader {

struct ConfinedLimits {
    /// Of address space, beyond what this process uses already.
    std::uint64_t memory_bytes = std::uint64_t{1} << 30;
    unsigned cpu_seconds = 10;
};

/// A copy of this process that does one piece of work. It can read the
/// descriptors of `keep` and write to its pipe; it can open nothing, start
/// nothing and write no file. What it sees of this process's memory it could
/// send along: the reader of the pipe believes nothing.
class Confined {
public:
    /// Precondition: this process has one thread. Throws SystemError.
    Confined(const ConfinedLimits& limits, std::span<const int> keep,
             const std::function<void(int out)>& work);
    Confined(const Confined&) = delete;
    Confined& operator=(const Confined&) = delete;
    ~Confined();  ///< ends the child if it still runs

    /// The read end of the child's pipe.
    int out() const { return out_.get(); }

    /// Waits for the end of the child. Empty when its work came to its end,
    /// else what happened: "its process was ended by signal 11 (...)".
    std::string how_it_failed();

private:
    course::Descriptor out_;
    pid_t pid_ = -1;
};

}  // namespace grader
