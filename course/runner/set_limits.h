// The limits of the process that a submission runs in.
#pragma once

#include "course/runner/limits.h"

namespace course {

/// Sets them for this process, which ends with 1 when that fails: CPU time,
/// output, stack, memory; no core dump; and a signal, SIGPROF, after each
/// cpu_ms of CPU.
void set_limits(const Limits& limits);

}  // namespace course
