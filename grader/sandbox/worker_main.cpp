// grader_worker SUBMISSION: the first process of a sandbox. Control channel on
// descriptor 3, the filter of system calls for workers on descriptor 4.
// grader_worker --probe: says that it runs, and ends.
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "course/runner/launcher.h"
#include "grader/sandbox/install_filter.h"

namespace {

std::string filter;

/// Reads the filter; false when there is none.
bool read_filter(int fd) {
    filter.resize(std::size_t{1} << 16);
    const ssize_t n = ::read(fd, filter.data(), filter.size());
    ::close(fd);
    filter.resize(static_cast<std::size_t>(n > 0 ? n : 0));
    return n > 0;
}

/// In each worker, before the submission is loaded.
void lock_down() {
    if (!grader::install_filter(filter)) ::_exit(1);
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
