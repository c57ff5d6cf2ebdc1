#include "course/runner/set_limits.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace course {

namespace {

// A template, since the type of RLIMIT_CPU is not the same everywhere.
template <class Resource>
void limit(Resource resource, rlim_t value) {
    const rlimit both{value, value};
    if (::setrlimit(resource, &both) != 0) ::_exit(1);
}

}  // namespace

void set_limits(const Limits& limits) {
    const timeval interval{limits.cpu_ms / 1000,
                           limits.cpu_ms % 1000 * suseconds_t{1000}};
    const itimerval timer{interval, interval};
    if (::setitimer(ITIMER_PROF, &timer, nullptr) != 0) ::_exit(1);
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_seconds));
    limit(RLIMIT_FSIZE, static_cast<rlim_t>(limits.output_kib) << 10);
    limit(RLIMIT_STACK, static_cast<rlim_t>(limits.stack_mib) << 20);
    limit(RLIMIT_CORE, 0);
#ifdef RLIMIT_AS
    limit(RLIMIT_AS, static_cast<rlim_t>(limits.memory_mib) << 20);
#endif
}

}  // namespace course
