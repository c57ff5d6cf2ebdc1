#include "course/runner/descriptors.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "course/runner/platform.h"

namespace course {

namespace {

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

constexpr std::size_t most_passed = 4;

void close_on_exec(int fd) {
    ::fcntl(fd, F_SETFD, FD_CLOEXEC);
}

/// Waits until `fd` is ready for `events`; false when time is up.
bool wait_for(int fd, short events, Clock::time_point until) {
    for (;;) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
        pollfd p{fd, events, 0};
        const int n =
            ::poll(&p, 1, static_cast<int>(std::max<long>(left.count(), 0)));
        if (n > 0) return true;
        if (n == 0) return false;
        if (errno != EINTR) throw_errno("poll");
    }
}

/// One sendmsg, with descriptors in its control data.
ssize_t send_some(int socket, std::string_view bytes,
                  std::span<const int> passed) {
    iovec io{const_cast<char*>(bytes.data()), bytes.size()};
    alignas(cmsghdr) char control[CMSG_SPACE(most_passed * sizeof(int))] = {};
    msghdr message{};
    message.msg_iov = &io;
    message.msg_iovlen = 1;
    if (!passed.empty()) {
        message.msg_control = control;
        message.msg_controllen = CMSG_SPACE(passed.size_bytes());
        cmsghdr* head = CMSG_FIRSTHDR(&message);
        head->cmsg_level = SOL_SOCKET;
        head->cmsg_type = SCM_RIGHTS;
        head->cmsg_len = CMSG_LEN(passed.size_bytes());
        std::memcpy(CMSG_DATA(head), passed.data(), passed.size_bytes());
    }
    return ::sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

/// One recvmsg, taking over the descriptors in its control data.
ssize_t receive_some(int fd, void* to, std::size_t size,
                     std::vector<Descriptor>& passed) {
    iovec io{to, size};
    alignas(cmsghdr) char control[CMSG_SPACE(most_passed * sizeof(int))] = {};
    msghdr message{};
    message.msg_iov = &io;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    const ssize_t n = ::recvmsg(fd, &message, 0);
    if (n < 0) return n;
    for (cmsghdr* head = CMSG_FIRSTHDR(&message); head != nullptr;
         head = CMSG_NXTHDR(&message, head)) {
        if (head->cmsg_type != SCM_RIGHTS) continue;
        int fds[most_passed];
        const std::size_t bytes = head->cmsg_len - CMSG_LEN(0);
        std::memcpy(fds, CMSG_DATA(head), std::min(bytes, sizeof fds));
        for (std::size_t k = 0; k < bytes / sizeof(int); ++k) {
            close_on_exec(fds[k]);
            passed.emplace_back(fds[k]);
        }
    }
    return n;
}

}  // namespace

void throw_errno(const std::string& what) {
    throw SystemError(what + ": " + std::strerror(errno));
}

void Descriptor::reset() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

DescriptorPair socket_pair() {
    int fds[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, fds) != 0)
        throw_errno("socketpair");
    close_on_exec(fds[0]);
    close_on_exec(fds[1]);
    return {Descriptor(fds[0]), Descriptor(fds[1])};
}

DescriptorPair pipe_pair() {
    int fds[2];
#if COURSE_LINUX
    // At once: another thread may be starting a program in between.
    if (::pipe2(fds, O_CLOEXEC) != 0) throw_errno("pipe");
#else
    if (::pipe(fds) != 0) throw_errno("pipe");
    close_on_exec(fds[0]);
    close_on_exec(fds[1]);
#endif
    return {Descriptor(fds[0]), Descriptor(fds[1])};
}

Descriptor anonymous_file() {
#if COURSE_LINUX
    Descriptor file(::memfd_create("output", MFD_CLOEXEC));
    if (!file) throw_errno("memfd_create");
    return file;
#else
    std::FILE* file = std::tmpfile();
    if (file == nullptr) throw_errno("tmpfile");
    Descriptor copy(::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3));
    std::fclose(file);
    return copy;
#endif
}

std::string last_bytes(int file) {
    constexpr off_t most = 2000;
    const off_t size = ::lseek(file, 0, SEEK_END);
    std::string text(static_cast<std::size_t>(std::min(size, most)), '\0');
    const ssize_t n = ::pread(file, text.data(), text.size(),
                              std::max<off_t>(size - most, 0));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    return text;
}

Transfer send_all(int socket, std::string_view bytes, Clock::time_point until,
                  std::span<const int> passed) {
    while (!bytes.empty()) {
        const ssize_t n = send_some(socket, bytes, passed);
        if (n > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(n));
            passed = {};
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!wait_for(socket, POLLOUT, until)) return Transfer::timed_out;
        } else if (errno != EINTR) {
            return Transfer::closed;
        }
    }
    return Transfer::done;
}

Transfer receive_all(int fd, std::string& to, std::size_t size,
                     Clock::time_point until) {
    constexpr std::size_t piece = std::size_t{1} << 20;
    to.clear();
    while (to.size() < size) {
        if (!wait_for(fd, POLLIN, until)) return Transfer::timed_out;
        const std::size_t have = to.size();
        to.resize(have + std::min(size - have, piece));
        const ssize_t n = ::read(fd, to.data() + have, to.size() - have);
        to.resize(have + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
        if (n == 0) return Transfer::closed;
        if (n < 0 && errno != EINTR && errno != EAGAIN) return Transfer::closed;
    }
    return Transfer::done;
}

bool has_input(int socket) {
    char byte = 0;
    return ::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

bool read_all(int fd, void* to, std::size_t size,
              std::vector<Descriptor>* passed) {
    auto* at = static_cast<char*>(to);
    while (size > 0) {
        const ssize_t n = passed != nullptr
                              ? receive_some(fd, at, size, *passed)
                              : ::read(fd, at, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        at += n;
        size -= static_cast<std::size_t>(n);
    }
    return true;
}

bool write_all(int fd, const void* from, std::size_t size) {
    const auto* at = static_cast<const char*>(from);
    while (size > 0) {
        const ssize_t n = ::write(fd, at, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        at += n;
        size -= static_cast<std::size_t>(n);
    }
    return true;
}

}  // namespace course
