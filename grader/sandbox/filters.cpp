#include "grader/sandbox/filters.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <memory>

#include "course/runner/descriptors.h"
#include "grader/sandbox/own_process.h"

namespace grader {

namespace {

/// A condition on one argument of a system call.
scmp_arg_cmp argument(unsigned index, scmp_compare how, std::uint64_t a,
                      std::uint64_t b = 0) {
    return {index, how, a, b};
}

class Filter {
public:
    explicit Filter(std::uint32_t otherwise)
        : context_(seccomp_init(otherwise), seccomp_release) {
        if (!context_) throw course::SystemError("seccomp_init failed");
        // 32-bit and x32 entries have other numbers: none is let through.
        check("arch", seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH,
                                       SCMP_ACT_KILL_PROCESS));
        check("optimise",
              seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2));
    }

    void rule(std::uint32_t action, std::initializer_list<const char*> names) {
        for (const char* name : names) rule_if(action, name, {});
    }

    /// With conditions on the arguments. A call that this machine does not
    /// know needs no rule.
    void rule_if(std::uint32_t action, const char* name,
                 std::initializer_list<scmp_arg_cmp> conditions) {
        const int number = seccomp_syscall_resolve_name(name);
        if (number == __NR_SCMP_ERROR) return;
        check(name,
              seccomp_rule_add_array(context_.get(), action, number,
                                     static_cast<unsigned>(conditions.size()),
                                     conditions.begin()));
    }

    std::string bytes() const {
        const course::Descriptor file = course::anonymous_file();
        check("export", seccomp_export_bpf(context_.get(), file.get()));
        std::string program(
            static_cast<std::size_t>(::lseek(file.get(), 0, SEEK_END)), '\0');
        if (::pread(file.get(), program.data(), program.size(), 0) < 0)
            course::throw_errno("pread");
        return program;
    }

private:
    static void check(const char* what, int result) {
        if (result < 0)
            throw course::SystemError(
                fmt::format("seccomp, {}: {}", what, std::strerror(-result)));
    }

    std::unique_ptr<void, void (*)(void*)> context_;
};

/// Files may be opened for reading only.
void allow_reading(Filter& filter, const char* name, unsigned flags_argument) {
    constexpr std::uint64_t writing =
        O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
    filter.rule_if(SCMP_ACT_ALLOW, name,
                   {argument(flags_argument, SCMP_CMP_MASKED_EQ, writing, 0)});
    for (const std::uint64_t flag :
         {std::uint64_t{O_WRONLY}, std::uint64_t{O_RDWR},
          std::uint64_t{O_CREAT}, std::uint64_t{O_TRUNC}})
        filter.rule_if(
            SCMP_ACT_KILL_PROCESS, name,
            {argument(flags_argument, SCMP_CMP_MASKED_EQ, flag, flag)});
}

}  // namespace

std::string compile_filter() {
    Filter filter(SCMP_ACT_ALLOW);
    filter.rule(SCMP_ACT_ERRNO(EPERM), {"socket",
                                        "socketpair",
                                        "ptrace",
                                        "process_vm_readv",
                                        "process_vm_writev",
                                        "process_madvise",
                                        "kcmp",
                                        "pidfd_open",
                                        "pidfd_getfd",
                                        "pidfd_send_signal",
                                        "keyctl",
                                        "add_key",
                                        "request_key",
                                        "bpf",
                                        "perf_event_open",
                                        "userfaultfd",
                                        "io_uring_setup",
                                        "io_uring_enter",
                                        "io_uring_register",
                                        "memfd_secret",
                                        "mount",
                                        "umount2",
                                        "pivot_root",
                                        "chroot",
                                        "move_mount",
                                        "open_tree",
                                        "fsopen",
                                        "fsconfig",
                                        "fsmount",
                                        "fspick",
                                        "mount_setattr",
                                        "unshare",
                                        "setns",
                                        "name_to_handle_at",
                                        "open_by_handle_at",
                                        "fanotify_init",
                                        "init_module",
                                        "finit_module",
                                        "delete_module",
                                        "kexec_load",
                                        "kexec_file_load",
                                        "reboot",
                                        "swapon",
                                        "swapoff",
                                        "acct",
                                        "quotactl",
                                        "syslog",
                                        "personality",
                                        "iopl",
                                        "ioperm",
                                        "modify_ldt",
                                        "settimeofday",
                                        "clock_settime",
                                        "clock_adjtime",
                                        "adjtimex",
                                        "mknod",
                                        "mknodat",
                                        "vhangup",
                                        "move_pages",
                                        "migrate_pages",
                                        "mbind",
                                        "set_mempolicy",
                                        "sethostname",
                                        "setdomainname"});
    // Its arguments lie in memory and cannot be checked; clone does the same.
    filter.rule(SCMP_ACT_ERRNO(ENOSYS), {"clone3"});
    for (const int flag : {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWNET,
                           CLONE_NEWPID, CLONE_NEWIPC, CLONE_NEWUTS})
        filter.rule_if(
            SCMP_ACT_ERRNO(EPERM), "clone",
            {argument(0, SCMP_CMP_MASKED_EQ, static_cast<std::uint64_t>(flag),
                      static_cast<std::uint64_t>(flag))});
    // Typing into somebody's terminal.
    constexpr std::uint64_t request = 0xffffffff;
    filter.rule_if(SCMP_ACT_ERRNO(EPERM), "ioctl",
                   {argument(1, SCMP_CMP_MASKED_EQ, request, TIOCSTI)});
    return filter.bytes();
}

std::string worker_filter() {
    Filter filter(SCMP_ACT_ERRNO(EPERM));
    filter.rule(SCMP_ACT_ALLOW, {"read",
                                 "write",
                                 "readv",
                                 "writev",
                                 "close",
                                 "lseek",
                                 "fstat",
                                 "newfstatat",
                                 "stat",
                                 "lstat",
                                 "statx",
                                 "poll",
                                 "ppoll",
                                 "select",
                                 "pselect6",
                                 "access",
                                 "faccessat",
                                 "faccessat2",
                                 "readlink",
                                 "readlinkat",
                                 "getcwd",
                                 "pread64",
                                 "mmap",
                                 "munmap",
                                 "mremap",
                                 "mprotect",
                                 "madvise",
                                 "brk",
                                 "rt_sigaction",
                                 "rt_sigprocmask",
                                 "rt_sigreturn",
                                 "sigaltstack",
                                 "rt_sigpending",
                                 "futex",
                                 "set_robust_list",
                                 "get_robust_list",
                                 "rseq",
                                 "set_tid_address",
                                 "sched_yield",
                                 "sched_getaffinity",
                                 "membarrier",
                                 "restart_syscall",
                                 "getpid",
                                 "gettid",
                                 "getppid",
                                 "getuid",
                                 "geteuid",
                                 "getgid",
                                 "getegid",
                                 "getrlimit",
                                 "getrusage",
                                 "times",

                                 "uname",
                                 "clock_gettime",
                                 "clock_getres",
                                 "gettimeofday",
                                 "time",
                                 "nanosleep",
                                 "clock_nanosleep",
                                 "getrandom",
                                 "getcpu",
                                 "exit",
                                 "exit_group",
                                 "arch_prctl"});
    allow_reading(filter, "open", 1);
    allow_reading(filter, "openat", 2);
    // Asking for limits, not setting them.
    filter.rule_if(SCMP_ACT_ALLOW, "prlimit64", {argument(2, SCMP_CMP_EQ, 0)});
    filter.rule_if(SCMP_ACT_ALLOW, "ioctl", {argument(1, SCMP_CMP_EQ, TCGETS)});
    // abort() raises a signal: in its own process only.
    filter.rule_if(SCMP_ACT_ALLOW, "tgkill",
                   {argument(0, SCMP_CMP_EQ, own_process)});
    filter.rule_if(SCMP_ACT_KILL_PROCESS, "tgkill",
                   {argument(0, SCMP_CMP_NE, own_process)});
    filter.rule(SCMP_ACT_ERRNO(ENOSYS), {"clone3"});
    filter.rule(SCMP_ACT_KILL_PROCESS, {"clone",
                                        "fork",
                                        "vfork",
                                        "execve",
                                        "execveat",
                                        "kill",
                                        "tkill",
                                        "rt_sigqueueinfo",
                                        "rt_tgsigqueueinfo",
                                        "ptrace",
                                        "process_vm_readv",
                                        "process_vm_writev",
                                        "pidfd_open",
                                        "pidfd_getfd",
                                        "pidfd_send_signal",
                                        "socket",
                                        "socketpair",
                                        "connect",
                                        "bind",
                                        "listen",
                                        "accept",
                                        "accept4",
                                        "sendto",
                                        "sendmsg",
                                        "sendmmsg",
                                        "recvfrom",
                                        "recvmsg",
                                        "recvmmsg",
                                        "io_uring_setup",
                                        "bpf",
                                        "userfaultfd",
                                        "perf_event_open",
                                        "keyctl",
                                        "add_key",
                                        "request_key",
                                        "mount",
                                        "umount2",
                                        "unshare",
                                        "setns",
                                        "pivot_root",
                                        "chroot",
                                        "memfd_create",
                                        "memfd_secret",
                                        "shmget",
                                        "shmat",
                                        "shmctl",
                                        "msgget",
                                        "semget",
                                        "setsid",
                                        "setpgid",
                                        "creat",
                                        "mkdir",
                                        "mkdirat",
                                        "unlink",
                                        "unlinkat",
                                        "rename",
                                        "renameat",
                                        "renameat2",
                                        "link",
                                        "linkat",
                                        "symlink",
                                        "symlinkat",
                                        "mknod",
                                        "mknodat",
                                        "chmod",
                                        "fchmodat",
                                        "chown",
                                        "fchownat",
                                        "truncate",
                                        "ftruncate",
                                        "reboot",
                                        "swapon",
                                        "init_module",
                                        "finit_module",
                                        "personality",
                                        "iopl",
                                        "ioperm",
                                        "modify_ldt",
                                        "seccomp",
                                        "sethostname"});
    return filter.bytes();
}

}  // namespace grader
