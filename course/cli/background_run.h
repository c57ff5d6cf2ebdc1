// Work of our own in a process of its own: it can be given up at any time, with
// the compiler and the programs that it has started.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "course/runner/descriptors.h"

namespace course {

class BackgroundRun {
public:
    /// Runs `work` in a copy of this process; what it prints becomes output(),
    /// what it returns code(). Precondition: no other thread runs. Throws
    /// SystemError.
    explicit BackgroundRun(const std::function<int()>& work);
    /// Gives it up if it still runs.
    ~BackgroundRun();
    BackgroundRun(const BackgroundRun&) = delete;
    BackgroundRun& operator=(const BackgroundRun&) = delete;

    /// To be polled for input before `has_ended` is asked.
    int descriptor() const { return from_.get(); }

    /// Takes what it has printed by now; true when it has come to its end.
    bool has_ended();

    const std::string& output() const { return output_; }
    int code() const { return code_; }

private:
    void collect();

    pid_t pid_ = -1;
    Descriptor from_;
    std::string output_;
    int code_ = 3;
};

}  // namespace course
