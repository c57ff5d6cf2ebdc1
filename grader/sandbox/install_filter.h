// Puts a filter of system calls on this process. Needs nothing but the kernel:
// the programs inside a sandbox use it, too.
#pragma once

#include <string_view>

namespace grader {

/// Installs a BPF program (filters.h) for this process and its children, with
/// its own process number where own_process.h stands. False, with errno, when
/// `bpf` is no program or the kernel refuses it.
bool install_filter(std::string_view bpf);

}  // namespace grader
