// grader_enter OPTIONS -- COMMAND...: gives up rights step by step, then
// becomes COMMAND. Before bubblewrap it sets limits and the user; where no
// namespaces are to be had, it is all that stands around COMMAND.
//
//   --parent N         end with this process, also if it has gone already
//   --join FILE        join a control group by writing "0" to this file of it
//   --cpu S            seconds of CPU        --memory MIB     address space
//   --file-size MIB    of any one file       --processes N    of the user
//   --user N           become this user and group, for good
//   --read PATH        Landlock: may read and execute below PATH
//   --write PATH       Landlock: may also write below PATH
//   --root DIR         change the root folder
//   --chdir DIR        then go there
//   --filter FD        install the filter of system calls that FD holds
//
// As soon as one --read or --write is given, everything else is out of reach,
// the network included. Exit code 125: COMMAND was never started.
#include <fcntl.h>
#include <getopt.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "grader/sandbox/install_filter.h"

namespace {

[[noreturn]] void give_up(const char* what) {
    std::fprintf(stderr, "grader_enter: %s: %s\n", what, std::strerror(errno));
    std::exit(125);
}

void must(bool done, const char* what) {
    if (!done) give_up(what);
}

struct Options {
    std::vector<std::string> join, read, write;
    rlim_t cpu = 0, memory_mib = 0, file_mib = 0, processes = 0;
    long user = -1;
    pid_t parent = -1;
    std::string root, folder;
    int filter = -1;
};

void take(Options& options, int option, const char* value) {
    const auto number = static_cast<rlim_t>(std::strtoul(value, nullptr, 10));
    switch (option) {
        case 'j':
            return options.join.emplace_back(value), void();
        case 'r':
            return options.read.emplace_back(value), void();
        case 'w':
            return options.write.emplace_back(value), void();
        case 'c':
            return void(options.cpu = number);
        case 'm':
            return void(options.memory_mib = number);
        case 'f':
            return void(options.file_mib = number);
        case 'p':
            return void(options.processes = number);
        case 'u':
            return void(options.user = static_cast<long>(number));
        case 'P':
            return void(options.parent = static_cast<pid_t>(number));
        case 'R':
            return void(options.root = value);
        case 'd':
            return void(options.folder = value);
        case 's':
            return void(options.filter = static_cast<int>(number));
        default:
            errno = EINVAL;
            give_up("usage");
    }
}

Options read_options(int argc, char** argv) {
    const option known[] = {{"parent", required_argument, nullptr, 'P'},
                            {"join", required_argument, nullptr, 'j'},
                            {"read", required_argument, nullptr, 'r'},
                            {"write", required_argument, nullptr, 'w'},
                            {"cpu", required_argument, nullptr, 'c'},
                            {"memory", required_argument, nullptr, 'm'},
                            {"file-size", required_argument, nullptr, 'f'},
                            {"processes", required_argument, nullptr, 'p'},
                            {"user", required_argument, nullptr, 'u'},
                            {"root", required_argument, nullptr, 'R'},
                            {"chdir", required_argument, nullptr, 'd'},
                            {"filter", required_argument, nullptr, 's'},
                            {nullptr, 0, nullptr, 0}};
    Options options;
    for (;;) {
        const int found = ::getopt_long(argc, argv, "+", known, nullptr);
        if (found == -1) return options;
        take(options, found, optarg);
    }
}

void join(const std::string& group) {
    const int fd = ::open(group.c_str(), O_WRONLY | O_CLOEXEC);
    must(fd >= 0 && ::write(fd, "0", 1) == 1, group.c_str());
    ::close(fd);
}

template <class Resource>
void limit(Resource resource, rlim_t value, const char* what) {
    const rlimit both{value, value};
    must(::setrlimit(resource, &both) == 0, what);
}

void set_limits(const Options& options) {
    limit(RLIMIT_CORE, 0, "core");
    limit(RLIMIT_NOFILE, 128, "open files");
    if (options.cpu > 0) limit(RLIMIT_CPU, options.cpu, "cpu");
    if (options.memory_mib > 0)
        limit(RLIMIT_AS, options.memory_mib << 20, "memory");
    if (options.file_mib > 0)
        limit(RLIMIT_FSIZE, options.file_mib << 20, "file size");
    if (options.processes > 0)
        limit(RLIMIT_NPROC, options.processes, "processes");
}

// ---- Landlock. The constants stand here since the kernel's own header may be
// older than the kernel. (Documentation/userspace-api/landlock.rst)

namespace landlock {

struct Ruleset {
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scoped = 0;
};
struct [[gnu::packed]] PathBeneath {
    std::uint64_t allowed;
    std::int32_t folder;
};
constexpr std::uint64_t execute = 1, write_file = 2, read_file = 4,
                        read_dir = 8, truncate = 1 << 14;
constexpr std::uint64_t make_char = 1 << 6, make_sock = 1 << 9,
                        make_fifo = 1 << 10, make_block = 1 << 11,
                        make_symlink = 1 << 12;
constexpr std::uint64_t reading = execute | read_file | read_dir;
constexpr std::uint64_t of_one_file =
    execute | write_file | read_file | truncate;

/// What a kernel of this version can forbid: everything.
Ruleset all_of(long version) {
    Ruleset rules;
    rules.files = (1u << 13) - 1;
    if (version >= 2) rules.files |= 1 << 13;  // moving between folders
    if (version >= 3) rules.files |= truncate;
    if (version >= 5) rules.files |= 1 << 15;  // ioctl of devices
    if (version >= 4) rules.network = 3;       // TCP: bind, connect
    if (version >= 6) rules.scoped = 3;        // abstract sockets, signals
    return rules;
}

std::size_t size_for(long version) {
    if (version >= 6) return sizeof(Ruleset);
    return version >= 4 ? 16 : 8;
}

void allow(int ruleset, const std::string& path, std::uint64_t what) {
    const int fd = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    struct stat status {};
    must(fd >= 0 && ::fstat(fd, &status) == 0, path.c_str());
    if (!S_ISDIR(status.st_mode)) what &= of_one_file;
    const PathBeneath rule{what, fd};
    constexpr int path_beneath = 1;
    must(::syscall(SYS_landlock_add_rule, ruleset, path_beneath, &rule, 0) == 0,
         path.c_str());
    ::close(fd);
}

/// The rules as a descriptor, made while the paths can still be opened.
int rules_of(const Options& options) {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1u);
    must(version >= 1, "Landlock");
    const Ruleset all = all_of(version);
    const int ruleset = static_cast<int>(
        ::syscall(SYS_landlock_create_ruleset, &all, size_for(version), 0));
    must(ruleset >= 0, "Landlock");
    for (const std::string& path : options.read) allow(ruleset, path, reading);
    const std::uint64_t writing =
        all.files &
        ~(make_char | make_sock | make_fifo | make_block | make_symlink);
    for (const std::string& path : options.write) allow(ruleset, path, writing);
    return ruleset;
}

}  // namespace landlock

void become(long user) {
    const auto id = static_cast<uid_t>(user);
    must(::setgroups(0, nullptr) == 0 && ::setresgid(id, id, id) == 0 &&
             ::setresuid(id, id, id) == 0,
         "changing the user");
}

std::string contents(int fd) {
    std::string bytes(std::size_t{1} << 16, '\0');
    const ssize_t n = ::pread(fd, bytes.data(), bytes.size(), 0);
    must(n > 0, "reading the filter");
    bytes.resize(static_cast<std::size_t>(n));
    ::close(fd);
    return bytes;
}

void enter(const Options& options) {
    for (const std::string& group : options.join) join(group);
    set_limits(options);
    const bool restricted = !options.read.empty() || !options.write.empty();
    const int rules = restricted ? landlock::rules_of(options) : -1;
    if (!options.root.empty())
        must(::chroot(options.root.c_str()) == 0 && ::chdir("/") == 0,
             "changing the root");
    if (options.user >= 0) become(options.user);
    if (!options.folder.empty())
        must(::chdir(options.folder.c_str()) == 0, options.folder.c_str());
    // After the change of user, which would take it back.
    must(::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 &&
             ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0,
         "prctl");
    must(options.parent < 0 || ::getppid() == options.parent, "the grader");
    if (restricted) {
        must(::syscall(SYS_landlock_restrict_self, rules, 0) == 0, "Landlock");
        ::close(rules);
    }
    if (options.filter >= 0)
        must(grader::install_filter(contents(options.filter)),
             "the filter of system calls");
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    must(optind < argc, "usage: no command");
    enter(options);
    ::execvp(argv[optind], argv + optind);
    give_up(argv[optind]);
}
