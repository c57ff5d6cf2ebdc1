// The two system-call filters of the sandbox, made by libseccomp.
#pragma once

#include <string>

namespace grader {

/// Deny-list for the compile step and for the launcher: what no compiler and
/// no launcher needs. As BPF, the way bubblewrap takes it.
std::string compile_filter();

/// Allow-list for a worker: memory, its channel, reading what is there. What
/// is plainly hostile ends the process by SIGSYS, the rest gets EPERM.
/// A worker puts its process number where own_process.h says.
std::string worker_filter();

}  // namespace grader
