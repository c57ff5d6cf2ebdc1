#include "course/runner/launcher.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "course/runner/descriptors.h"
#include "course/runner/platform.h"
#include "course/runner/protocol.h"
#include "course/runner/set_limits.h"

#if COURSE_LINUX
#include <sys/prctl.h>
#endif

namespace course {

namespace {

// A worker says on this descriptor that it is set up, and closes it before the
// submission is loaded: a worker that cannot be set up is our fault, and no
// exit code of a submission looks like it.
constexpr int ready_descriptor = 4;

[[noreturn]] void give_up() {
    ::_exit(1);
}

int wake_up_pipe = -1;

void on_child(int) {
    const int saved = errno;
    const char byte = 0;
    [[maybe_unused]] const ssize_t n = ::write(wake_up_pipe, &byte, 1);
    errno = saved;
}

void close_from(int first) {
#if COURSE_LINUX
    ::close_range(static_cast<unsigned>(first), ~0U, 0);
#else
    for (int fd = first; fd < 256; ++fd) ::close(fd);
#endif
}

/// 0: nothing to read; 1 and 2: the output file; 3: the channel; 4: ready.
void arrange_descriptors(int channel, int output, int ready) {
    int empty[2];
    if (::pipe(empty) != 0) give_up();
    constexpr int out_of_the_way = 20;
    const int wanted[] = {empty[0], output, output, channel, ready};
    int moved[5];
    for (int fd = 0; fd < 5; ++fd)
        moved[fd] = ::fcntl(wanted[fd], F_DUPFD, out_of_the_way);
    for (int fd = 0; fd < 5; ++fd)
        if (::dup2(moved[fd], fd) != fd) give_up();
    close_from(ready_descriptor + 1);
}

[[noreturn]] void be_worker(const LauncherOptions& options,
                            const Limits& limits, int channel, int output,
                            int ready) {
    ::setpgid(0, 0);  // so that its children can be ended with it
#if COURSE_LINUX
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    arrange_descriptors(channel, output, ready);
    std::signal(SIGCHLD, SIG_DFL);
    std::signal(SIGXFSZ, SIG_DFL);  // who prints too much is ended
    set_limits(limits);
    if (options.lock_down != nullptr) options.lock_down();
    if (!write_all(ready_descriptor, "r", 1)) give_up();
    ::close(ready_descriptor);
    serve_calls(options.submission, 3);
    ::_exit(0);
}

class Launcher {
public:
    explicit Launcher(const LauncherOptions& options) : options_(options) {}

    int run();

private:
    void obey(const LauncherOrder& order,
              const std::vector<Descriptor>& passed);
    void start(const LauncherOrder& order,
               const std::vector<Descriptor>& passed);
    void end_worker() const;
    void collect();
    void tell(Event event, std::int32_t status, const rusage& usage = {}) const;

    const LauncherOptions& options_;
    pid_t worker_ = -1;
    std::uint32_t generation_ = 0;
};

std::int64_t microseconds(const timeval& t) {
    return std::int64_t{1'000'000} * t.tv_sec + t.tv_usec;
}

void Launcher::tell(Event event, std::int32_t status,
                    const rusage& usage) const {
    const std::int64_t user_us = microseconds(usage.ru_utime);
    const LauncherEvent message{event, generation_, status,
                                static_cast<std::int32_t>(user_us / 1000),
                                user_us + microseconds(usage.ru_stime)};
    if (!write_all(options_.control, &message, sizeof message)) ::_exit(0);
}

void Launcher::start(const LauncherOrder& order,
                     const std::vector<Descriptor>& passed) {
    generation_ = order.generation;
    if (worker_ > 0 || passed.size() != 2)
        return tell(Event::not_started, EBUSY);
    DescriptorPair ready = pipe_pair();
    const pid_t pid = ::fork();
    if (pid == 0)
        be_worker(options_, order.limits, passed[0].get(), passed[1].get(),
                  ready.second.get());
    if (pid < 0) return tell(Event::not_started, errno);
    ready.second.reset();
    char byte = 0;
    if (!read_all(ready.first.get(), &byte, 1))
        return tell(Event::not_started, ECHILD);
    worker_ = pid;
    tell(Event::started, 0);
}

void Launcher::end_worker() const {
    if (worker_ <= 0) return;
    ::kill(-worker_, SIGKILL);  // with all that it may have started
    ::kill(worker_, SIGKILL);   // its group may not exist yet
}

void Launcher::obey(const LauncherOrder& order,
                    const std::vector<Descriptor>& passed) {
    if (order.order == Order::start_worker)
        start(order, passed);
    else if (order.generation == generation_)
        end_worker();
}

/// Collects ended processes; when the worker is among them, ends all that it
/// may have started, and says so only when nothing of it is left.
void Launcher::collect() {
    int status = 0;
    rusage usage{};
    pid_t pid = 0;
    while ((pid = ::wait4(-1, &status, WNOHANG, &usage)) > 0) {
        if (pid != worker_) continue;
        ::kill(-worker_, SIGKILL);
        if (::getpid() == 1) {
            ::kill(-1, SIGKILL);
            while (::wait4(-1, nullptr, 0, nullptr) > 0) {
            }
        }
        worker_ = -1;
        tell(Event::ended, status, usage);
    }
}

int Launcher::run() {
    const DescriptorPair wake_up = pipe_pair();
    wake_up_pipe = wake_up.second.get();
    ::fcntl(wake_up_pipe, F_SETFL, O_NONBLOCK);
    ::fcntl(wake_up.first.get(), F_SETFL, O_NONBLOCK);
    std::signal(SIGCHLD, on_child);
    for (;;) {
        pollfd p[2] = {{options_.control, POLLIN, 0},
                       {wake_up.first.get(), POLLIN, 0}};
        if (::poll(p, 2, -1) < 0) continue;
        if (p[1].revents != 0) {
            char drained[64];
            while (::read(wake_up.first.get(), drained, sizeof drained) > 0) {
            }
            collect();
        }
        if (p[0].revents == 0) continue;
        LauncherOrder order{};
        std::vector<Descriptor> passed;
        if (!read_all(options_.control, &order, sizeof order, &passed))
            break;  // the judge is gone
        obey(order, passed);
    }
    end_worker();
    return 0;
}

}  // namespace

int run_launcher(const LauncherOptions& options) {
#if COURSE_LINUX
    ::prctl(PR_SET_DUMPABLE, 0);  // no worker looks into this process
#endif
    ::fcntl(options.control, F_SETFD, FD_CLOEXEC);
    return Launcher(options).run();
}

}  // namespace course
