#include "course/cli/background_run.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include "course/runner/process.h"

namespace course {

namespace {

/// The rest of the life of the copy.
[[noreturn]] void run_and_exit(const std::function<int()>& work, int to) {
    ::setpgid(0, 0);
    int code = 3;
    try {
        end_programs_with_this_process();
        ::dup2(to, 1);
        ::dup2(to, 2);
        code = work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lab: %s\n", error.what());
    }
    std::fflush(nullptr);
    ::_exit(code);
}

}  // namespace

BackgroundRun::BackgroundRun(const std::function<int()>& work) {
    DescriptorPair pipe = pipe_pair();
    std::fflush(nullptr);
    pid_ = ::fork();
    if (pid_ < 0) throw_errno("fork");
    if (pid_ == 0) run_and_exit(work, pipe.second.get());
    from_ = std::move(pipe.first);
    ::fcntl(from_.get(), F_SETFL, O_NONBLOCK);
}

BackgroundRun::~BackgroundRun() {
    if (pid_ > 0) ::kill(pid_, SIGKILL);
    collect();
}

bool BackgroundRun::has_ended() {
    char buffer[1 << 12];
    ssize_t n = 0;
    while ((n = ::read(from_.get(), buffer, sizeof buffer)) > 0)
        output_.append(buffer, static_cast<std::size_t>(n));
    if (n < 0 && (errno == EAGAIN || errno == EINTR)) return false;
    collect();
    return true;
}

void BackgroundRun::collect() {
    int status = 0;
    if (pid_ > 0 && ::waitpid(pid_, &status, 0) == pid_ && WIFEXITED(status))
        code_ = WEXITSTATUS(status);
    pid_ = -1;
}

}  // namespace course
