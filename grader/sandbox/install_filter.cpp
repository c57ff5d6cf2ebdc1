#include "grader/sandbox/install_filter.h"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "grader/sandbox/own_process.h"

namespace grader {

bool install_filter(std::string_view bpf) {
    if (bpf.empty() || bpf.size() % sizeof(sock_filter) != 0) {
        errno = EINVAL;
        return false;
    }
    std::vector<sock_filter> program(bpf.size() / sizeof(sock_filter));
    std::memcpy(program.data(), bpf.data(), bpf.size());
    for (sock_filter& instruction : program)
        if (instruction.k == own_process)
            instruction.k = static_cast<unsigned>(::getpid());
    const sock_fprog whole{static_cast<unsigned short>(program.size()),
                           program.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &whole) == 0;
}

}  // namespace grader
