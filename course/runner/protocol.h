// The two conversations of a judge: with the launcher, which starts and ends
// workers, and with a worker, which holds the submission.
#pragma once

#include <cstdint>

#include "course/runner/limits.h"

namespace course {

// ---- judge and launcher: both are ours

enum class Order : std::uint32_t { start_worker = 1, end_worker = 2 };
enum class Event : std::uint32_t { started = 1, ended = 2, not_started = 3 };

/// start_worker comes with two descriptors: the worker's end of the channel,
/// and the file that it prints into.
struct LauncherOrder {
    Order order;
    std::uint32_t generation;  ///< which worker is meant
    Limits limits;
};

struct LauncherEvent {
    Event event;
    std::uint32_t generation;
    std::int32_t status;   ///< as from waitpid, or errno when not started
    std::int32_t user_ms;  ///< user time of the worker
    std::int64_t cpu_us;   ///< user and system time of the worker
};

// ---- judge and worker: the worker is hostile

inline constexpr std::uint32_t request_magic = 0x51454845;
inline constexpr std::uint32_t reply_magic = 0x52454845;

/// How a call ended, as the worker says.
enum class CallStatus : std::uint32_t {
    returned = 0,        ///< trace, then the result
    threw = 1,           ///< trace, then type and text
    out_of_table = 2,    ///< trace, then text
    too_many_reads = 3,  ///< trace, then text
    out_of_memory = 4,   ///< trace
    not_loaded = 5,      ///< text: why the submission could not be loaded
    crashed = 6,         ///< Crash, as it lies in memory
    many = 7,            ///< of a request: for several calls, see below
};

/// A request: tables that are new to the worker (count, then of each its id,
/// whether it is made of copies, and its rows or the Copies), then the
/// arguments; a table is named by its id and its read budget. One for many
/// calls has instead of the arguments their number, and for each the length of
/// its arguments and they; to which the reply `returned` has, behind the trace
/// of the last call, the nonce, the reads, the length of the result and the
/// result of each. One call that fails is the reply to all.
struct FrameHead {
    std::uint32_t magic;
    CallStatus status;     ///< of a request: returned for one call, or many
    std::uint64_t length;  ///< bytes that follow
    std::uint64_t nonce;   ///< a reply repeats the one of its request
};

/// What a signal handler can still say.
struct Crash {
    std::int32_t signal;
    std::int32_t stack_overflow;  ///< 1 when the address lies below the stack
    std::int32_t out_of_memory;   ///< 1 when there was hardly any left
    std::int32_t visit_count;
    std::int32_t visits[64][2];  ///< half-edge and line, oldest first
};

}  // namespace course
