// Work in a copy of the process.
#include "course/bench/fresh_process.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace bench {

namespace {

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) +
           1e-9 * static_cast<double>(time.tv_nsec);
}

/// A line of /proc/self/status, in bytes.
std::int64_t status(const std::string& name) {
    std::ifstream in("/proc/self/status");
    std::string word;
    std::int64_t kilobytes = 0;
    while (in >> word && word != name) {
    }
    in >> kilobytes;
    return 1024 * kilobytes;
}

Cost measured(const std::function<void()>& work) {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // forgets the peak
    const std::int64_t before = status("VmRSS:");
    const double start = processor_seconds();
    work();
    const double seconds = processor_seconds() - start;
    return {seconds, status("VmHWM:") - before};
}

[[noreturn]] void run_child(const std::function<void()>& work, int out) {
    try {
        const Cost cost = measured(work);
        _exit(write(out, &cost, sizeof cost) == sizeof cost ? 0 : 1);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        _exit(1);
    }
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
    const pid_t child = fork();
    if (child == 0) run_child(work, ends[1]);
    close(ends[1]);
    Cost cost;
    const bool whole = read(ends[0], &cost, sizeof cost) == sizeof cost;
    close(ends[0]);
    int state = 0;
    if (child > 0) waitpid(child, &state, 0);
    if (!whole) throw std::runtime_error("the measured process failed");
    return cost;
}

}  // namespace bench
