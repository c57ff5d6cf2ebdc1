// File descriptors with an owner, and whole reads and writes with a deadline.
#pragma once

#include <chrono>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace course {

using Clock = std::chrono::steady_clock;

/// Thrown when a system call fails; says which and why.
struct SystemError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// SystemError with `what` and the text of errno.
[[noreturn]] void throw_errno(const std::string& what);

/// A file descriptor that is closed with its owner.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept
        : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    ~Descriptor() { reset(); }

    int get() const { return fd_; }
    explicit operator bool() const { return fd_ >= 0; }
    void reset();

private:
    int fd_ = -1;
};

struct DescriptorPair {
    Descriptor first, second;
};

/// Two connected local sockets, and a pipe (first: read end), both closed on
/// exec. Throw SystemError.
DescriptorPair socket_pair();
DescriptorPair pipe_pair();

/// An empty file that has no name. Throws SystemError.
Descriptor anonymous_file();

/// The end of a file, at most 2000 bytes of it.
std::string last_bytes(int file);

enum class Transfer { done, closed, timed_out };

/// Sends all bytes, with the descriptors of `passed` beside the first one. The
/// socket does not block and raises no signal.
Transfer send_all(int socket, std::string_view bytes, Clock::time_point until,
                  std::span<const int> passed = {});

/// Reads exactly `size` bytes into `to`, in pieces: memory is taken only for
/// what has arrived.
Transfer receive_all(int fd, std::string& to, std::size_t size,
                     Clock::time_point until);

/// Whether bytes wait on a socket; the end of its input is none.
bool has_input(int socket);

/// Reads exactly `size` bytes, blocking, with descriptors that came along.
/// False at the end of input.
bool read_all(int fd, void* to, std::size_t size,
              std::vector<Descriptor>* passed = nullptr);

/// Writes all bytes, blocking. False when nobody reads any more.
bool write_all(int fd, const void* from, std::size_t size);

}  // namespace course
