// grader_worker SUBMISSION: the first process of a sandbox. Control channel on
// descriptor 3, the filter of system calls for workers on descriptor 4.
// grader_worker --probe: says that it runs, and ends.
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>
#include <vector>

#include "course/runner/launcher.h"
#include "grader/sandbox/own_process.h"

namespace {

std::vector<sock_filter> filter;

/// Reads the filter; false when there is none.
bool read_filter(int fd) {
    std::vector<sock_filter> program(4096);
    const ssize_t n =
        ::read(fd, program.data(), program.size() * sizeof(sock_filter));
    ::close(fd);
    if (n <= 0 || static_cast<std::size_t>(n) % sizeof(sock_filter) != 0)
        return false;
    program.resize(static_cast<std::size_t>(n) / sizeof(sock_filter));
    filter = program;
    return true;
}

/// In each worker, before the submission is loaded.
void lock_down() {
    for (sock_filter& instruction : filter)
        if (instruction.k == grader::own_process)
            instruction.k = static_cast<unsigned>(::getpid());
    const sock_fprog program{static_cast<unsigned short>(filter.size()),
                             filter.data()};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0)
        ::_exit(1);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--probe") {
        std::puts("ready");
        return 0;
    }
    if (argc != 2 || !read_filter(4)) {
        std::fputs("usage: grader_worker SUBMISSION.so (started by grader)\n",
                   stderr);
        return 2;
    }
    return course::run_launcher({argv[1], 3, lock_down});
}
