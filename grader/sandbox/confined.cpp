#include "grader/sandbox/confined.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "grader/sandbox/filters.h"
#include "grader/sandbox/install_filter.h"

namespace grader {

namespace {

enum ExitCode { done = 0, not_confined = 10, out_of_memory = 11, failed = 12 };

/// The address space of this process, in bytes.
std::uint64_t address_space() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Closes every descriptor but those; false when the system cannot.
bool close_others(std::vector<int> keep) {
    std::sort(keep.begin(), keep.end());
    unsigned first = 0;
    for (const int fd : keep) {
        const auto number = static_cast<unsigned>(fd);
        if (number > first && ::close_range(first, number - 1, 0) != 0)
            return false;
        first = number + 1;
    }
    return ::close_range(first, ~0u, 0) == 0;
}

/// Beyond `most` it is told, one later it is ended.
bool limit(__rlimit_resource what, rlim_t most) {
    const rlimit value{most, most + (what == RLIMIT_CPU ? 1 : 0)};
    return ::setrlimit(what, &value) == 0;
}

/// Takes every right from this process. Of descriptors none can be added:
/// the filter would let files be opened for reading.
bool confine(const ConfinedLimits& limits, std::uint64_t space,
             const std::string& filter) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXCPU, SIGSEGV, SIGBUS,
                             SIGILL, SIGFPE, SIGABRT})
        std::signal(signal, SIG_DFL);
    return limit(RLIMIT_AS, space + limits.memory_bytes) &&
           limit(RLIMIT_CPU, limits.cpu_seconds) && limit(RLIMIT_FSIZE, 0) &&
           limit(RLIMIT_CORE, 0) && limit(RLIMIT_NOFILE, 0) &&
           install_filter(filter);
}

int exit_code_of(const std::function<void(int)>& work, int out) {
    try {
        work(out);
        return done;
    } catch (const std::bad_alloc&) {
        return out_of_memory;
    } catch (...) {
        return failed;
    }
}

/// Its status as from waitpid. One that has closed its pipe and goes on is
/// ended after a while.
int end_of(pid_t pid) {
    using namespace std::chrono_literals;
    int status = 0;
    for (int k = 0; k < 200; ++k) {
        if (::waitpid(pid, &status, WNOHANG) == pid) return status;
        std::this_thread::sleep_for(k < 100 ? 1ms : 20ms);
    }
    ::kill(pid, SIGKILL);
    while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
    return status;
}

}  // namespace

Confined::Confined(const ConfinedLimits& limits, std::span<const int> keep,
                   const std::function<void(int out)>& work) {
    course::DescriptorPair pipe = course::pipe_pair();
    const std::string filter = worker_filter();
    const std::uint64_t space = address_space();
    std::vector<int> kept(keep.begin(), keep.end());
    kept.push_back(pipe.second.get());
    pid_ = ::fork();
    if (pid_ < 0) course::throw_errno("fork");
    if (pid_ == 0) {
        if (!close_others(kept) || !confine(limits, space, filter))
            ::_exit(not_confined);
        ::_exit(exit_code_of(work, pipe.second.get()));
    }
    out_ = std::move(pipe.first);
}

Confined::~Confined() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    how_it_failed();
}

std::string Confined::how_it_failed() {
    const int status = end_of(std::exchange(pid_, -1));
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return "its process used more time than it may";
    if (WIFSIGNALED(status))
        return fmt::format("its process was ended by signal {} ({})",
                           WTERMSIG(status), ::strsignal(WTERMSIG(status)));
    switch (WEXITSTATUS(status)) {
        case done:
            return {};
        case not_confined:
            return "this machine cannot confine its process";
        case out_of_memory:
            return "its process ran out of memory";
        default:
            return "its process failed";
    }
}

}  // namespace grader
