#include "course/runner/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <set>
#include <thread>

#include "course/runner/platform.h"

namespace course {

namespace {

std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> list;
    list.reserve(texts.size() + 1);
    for (const std::string& text : texts)
        list.push_back(const_cast<char*>(text.c_str()));
    list.push_back(nullptr);
    return list;
}

/// What posix_spawn is to do with descriptors, and copies that are out of the
/// way of each other until then.
class SpawnActions {
public:
    explicit SpawnActions(const Command& command) {
        ::posix_spawn_file_actions_init(&actions_);
        for (int fd = 0; fd < 3; ++fd)
            if (!is_given(command, fd))
                ::posix_spawn_file_actions_addopen(&actions_, fd, "/dev/null",
                                                   O_RDWR, 0);
        for (const auto& [ours, theirs] : command.descriptors) {
            constexpr int out_of_the_way = 64;
            copies_.emplace_back(
                ::fcntl(ours, F_DUPFD_CLOEXEC, out_of_the_way));
            if (!copies_.back()) throw_errno("fcntl");
            ::posix_spawn_file_actions_adddup2(&actions_, copies_.back().get(),
                                               theirs);
        }
    }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }

    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    static bool is_given(const Command& command, int fd) {
        return std::any_of(command.descriptors.begin(),
                           command.descriptors.end(),
                           [&](const auto& pair) { return pair.second == fd; });
    }

    posix_spawn_file_actions_t actions_{};
    std::vector<Descriptor> copies_;
};

/// Keeps this thread on a processor for as long as it lives: what is started in
/// that time stays there.
class OnProcessor {
public:
    explicit OnProcessor([[maybe_unused]] std::optional<int> processor) {
#if COURSE_LINUX
        if (!processor || ::sched_getaffinity(0, sizeof usual_, &usual_) != 0)
            return;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(*processor), &one);
        kept_ = ::sched_setaffinity(0, sizeof one, &one) == 0;
#endif
    }
    OnProcessor(const OnProcessor&) = delete;
    OnProcessor& operator=(const OnProcessor&) = delete;
    ~OnProcessor() {
#if COURSE_LINUX
        if (kept_) ::sched_setaffinity(0, sizeof usual_, &usual_);
#endif
    }

private:
#if COURSE_LINUX
    cpu_set_t usual_{};
    bool kept_ = false;
#endif
};

/// Head and tail of what a program printed.
class Capture {
public:
    explicit Capture(std::size_t most) : half_(most / 2) {}

    void add(std::string_view text) {
        const std::size_t room = half_ - std::min(half_, head_.size());
        head_ += text.substr(0, room);
        tail_ += text.substr(std::min(room, text.size()));
        if (tail_.size() > 2 * half_) drop(tail_.size() - half_);
    }
    std::string text() {
        if (tail_.size() > half_) drop(tail_.size() - half_);
        if (dropped_ == 0) return head_ + tail_;
        return fmt::format("{}\n[... {} bytes left out ...]\n{}", head_,
                           dropped_, tail_);
    }

private:
    void drop(std::size_t n) {
        tail_.erase(0, n);
        dropped_ += n;
    }

    std::size_t half_;
    std::string head_, tail_;
    std::size_t dropped_ = 0;
};

/// Reads until the other end is closed; false when time is up first.
bool read_to_end(int fd, Capture& capture, Clock::time_point until) {
    std::string piece;
    char buffer[1 << 16];
    for (;;) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
        pollfd p{fd, POLLIN, 0};
        const int ready =
            ::poll(&p, 1, static_cast<int>(std::max<long>(left.count(), 0)));
        if (ready == 0 || Clock::now() > until) return false;
        const ssize_t n = ::read(fd, buffer, sizeof buffer);
        if (n == 0) return true;
        if (n > 0) capture.add({buffer, static_cast<std::size_t>(n)});
    }
}

/// The end of a pipe to the process that outlives this one by a moment. It is
/// told each program that has been started (its number) and ended (minus that).
int to_warden = -1;

void tell_warden(std::int32_t program) {
    if (to_warden < 0) return;
    [[maybe_unused]] const ssize_t n =
        ::write(to_warden, &program, sizeof program);
}

/// Reads until the other process is gone, then ends what it left.
[[noreturn]] void be_warden(int from) {
    ::setsid();  // who ends the whole group of the other spares this one
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
        std::signal(signal, SIG_IGN);
    ::dup2(from, 0);
#if COURSE_LINUX
    ::close_range(1, ~0U, 0);
#else
    for (int fd = 1; fd < 256; ++fd) ::close(fd);
#endif
    std::set<pid_t> running;
    std::int32_t program = 0;
    while (read_all(0, &program, sizeof program))
        if (program > 0)
            running.insert(program);
        else
            running.erase(-program);
    for (const pid_t one : running) ::kill(-one, SIGKILL);
    ::_exit(0);
}

}  // namespace

void end_programs_with_this_process() {
    DescriptorPair pipe = pipe_pair();
    const pid_t pid = ::fork();
    if (pid < 0) throw_errno("fork");
    if (pid == 0) {
        pipe.second.reset();
        be_warden(pipe.first.get());
    }
    static Descriptor kept;
    kept = std::move(pipe.second);
    to_warden = kept.get();
}

std::vector<std::string> plain_environment() {
    const char* path = std::getenv("PATH");
    return {fmt::format("PATH={}", path != nullptr ? path : "/usr/bin:/bin"),
            "LC_ALL=C.UTF-8"};
}

Process::Process(const Command& command) {
    const SpawnActions actions(command);
    posix_spawnattr_t attributes{};
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ})
        sigaddset(&usual, signal);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    // A session and a group of its own: no terminal to reach, Ctrl-C there is
    // for this process to handle, and the group can be ended as one.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK |
                                                POSIX_SPAWN_SETSIGDEF |
                                                POSIX_SPAWN_SETSID);
    const OnProcessor here(command.processor);
    const int error =
        ::posix_spawnp(&pid_, command.arguments.at(0).c_str(), actions.get(),
                       &attributes, pointers(command.arguments).data(),
                       pointers(command.environment).data());
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0) {
        pid_ = -1;
        throw SystemError(fmt::format("cannot start {}: {}",
                                      command.arguments.at(0),
                                      std::strerror(error)));
    }
    tell_warden(pid_);
}

Process::~Process() {
    kill();
    wait();
}

int Process::wait() {
    int status = 0;
    while (pid_ > 0 && ::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    forget();
    return status;
}

/// It has been collected: its number may be another's from now on.
void Process::forget() {
    if (pid_ > 0) tell_warden(-pid_);
    pid_ = -1;
}

void Process::kill() {
    if (pid_ <= 0) return;
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);
}

void Process::end_within(std::chrono::milliseconds most) {
    const auto until = Clock::now() + most;
    while (pid_ > 0 && Clock::now() < until) {
        if (::waitpid(pid_, nullptr, WNOHANG) == pid_) forget();
        if (pid_ > 0)
            std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    kill();
    wait();
}

Finished run(Command command, std::chrono::milliseconds most,
             std::size_t most_bytes) {
    DescriptorPair pipe = pipe_pair();
    command.descriptors.emplace_back(pipe.second.get(), 1);
    command.descriptors.emplace_back(pipe.second.get(), 2);
    Process process(command);
    pipe.second.reset();
    Capture capture(most_bytes);
    Finished finished;
    finished.timed_out =
        !read_to_end(pipe.first.get(), capture, Clock::now() + most);
    if (finished.timed_out) process.kill();
    finished.status = process.wait();
    finished.output = capture.text();
    return finished;
}

}  // namespace course
