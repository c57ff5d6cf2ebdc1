// The loop of a worker: load the submission, then answer one request after the
// other. A crash is reported by the signal handler as far as it still can.
#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <optional>

#include "course/halfedge/copies.h"
#include "course/halfedge/table_errors.h"
#include "course/runner/descriptors.h"
#include "course/runner/exception_type.h"
#include "course/runner/launcher.h"
#include "course/runner/protocol.h"
#include "course/runner/worker.h"

namespace course {

namespace {

/// What the signal handler needs; there is no other way to reach it.
struct Running {
    int channel = -1;
    FrameHead request{};
    const WorkerCall* call = nullptr;
    const char* stack_top = nullptr;
    std::size_t stack_size = 0;
};

Running running;

bool below_the_stack(const void* address) {
    const auto depth = running.stack_top - static_cast<const char*>(address);
    const auto size = static_cast<std::ptrdiff_t>(running.stack_size);
    return depth > size - size / 8 && depth < size + size / 8;
}

/// Whether the address space is used up: a null pointer that comes from an
/// allocation that failed is no ordinary crash.
bool no_memory_left() {
    constexpr std::size_t little = std::size_t{32} << 20;
    void* probe =
        ::mmap(nullptr, little, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return true;
    ::munmap(probe, little);
    return false;
}

/// Async-signal-safe: plain memory and system calls.
void on_crash(int signal, siginfo_t* info, void*) {
    Crash crash{};
    crash.signal = signal;
    crash.stack_overflow =
        signal != SIGABRT && below_the_stack(info->si_addr) ? 1 : 0;
    crash.out_of_memory = no_memory_left() ? 1 : 0;
    if (running.call != nullptr && running.call->walked != nullptr) {
        Visit visits[HalfEdgeTable::last_visits_size];
        crash.visit_count = running.call->walked->copy_last_visits(visits);
        for (int k = 0; k < crash.visit_count; ++k) {
            crash.visits[k][0] = visits[k].i;
            crash.visits[k][1] = visits[k].line;
        }
    }
    // Unasked, nothing may be sent: the judge would take it for a forgery.
    if (running.call != nullptr) {
        const FrameHead head{reply_magic, CallStatus::crashed, sizeof crash,
                             running.request.nonce};
        write_all(running.channel, &head, sizeof head);
        write_all(running.channel, &crash, sizeof crash);
    }
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

long memory_before = 0;

/// Some CPU time has passed: who has not taken more memory since is in a loop.
/// Async-signal-safe.
void on_time_passed(int signal) {
    constexpr long little = 4096;  // KiB; on macOS bytes: then almost any
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const long more = usage.ru_maxrss - memory_before;
    memory_before = usage.ru_maxrss;
    if (more >= little) return;
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void catch_crashes() {
    static char handler_stack[1 << 16];
    stack_t stack{};
    stack.ss_sp = handler_stack;
    stack.ss_size = sizeof handler_stack;
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = on_crash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        ::sigaction(signal, &action, nullptr);
    struct sigaction passed {};
    passed.sa_handler = on_time_passed;
    passed.sa_flags = SA_ONSTACK | SA_RESTART;
    ::sigaction(SIGPROF, &passed, nullptr);
}

bool reply(CallStatus status, const std::string& body) {
    running.call = nullptr;  // answered: a crash after it is no answer
    const FrameHead head{reply_magic, status, body.size(),
                         running.request.nonce};
    std::string frame(reinterpret_cast<const char*>(&head), sizeof head);
    frame += body;
    return write_all(running.channel, frame.data(), frame.size());
}

/// How the walk went: reads in all, and the last of them.
Writer trace_of(const WorkerCall& call) {
    Writer out;
    std::vector<std::int32_t> visits;
    std::int64_t reads = 0;
    if (call.walked != nullptr) {
        reads = call.walked->reads();
        for (const Visit& visit : call.walked->last_visits()) {
            visits.push_back(visit.i);
            visits.push_back(visit.line);
        }
    }
    put(out, reads);
    put(out, visits);
    return out;
}

/// The start of a text of the submission; it may be of any length.
std::string start_of(const char* text) {
    constexpr std::size_t most = 4096;
    return std::string(text, ::strnlen(text, most));
}

bool reply_text(const WorkerCall& call, CallStatus status,
                const std::string& text) {
    Writer out = trace_of(call);
    put(out, text);
    return reply(status, out.bytes);
}

bool reply_exception(const WorkerCall& call, const std::string& text) {
    Writer out = trace_of(call);
    put(out, type_of_exception());
    put(out, text);
    return reply(CallStatus::threw, out.bytes);
}

/// Calls the student's function. Nothing when it returned; else what came of
/// it was sent, and the value says whether it could be.
std::optional<bool> failed(const Entry& entry, WorkerCall& call) {
    running.call = &call;
    try {
        entry.call(call);
        return std::nullopt;
    } catch (const OutOfTable& error) {
        return reply_text(call, CallStatus::out_of_table, error.what());
    } catch (const TooManyReads& error) {
        return reply_text(call, CallStatus::too_many_reads, error.what());
    } catch (const std::bad_alloc&) {
        return reply(CallStatus::out_of_memory, trace_of(call).bytes);
    } catch (const std::exception& error) {
        return reply_exception(call, start_of(error.what()));
    } catch (...) {
        return reply_exception(call, "");
    }
}

bool answer(const Entry& entry, WorkerCall& call) {
    if (const auto sent = failed(entry, call)) return *sent;
    Writer out = trace_of(call);
    out.raw(call.out.bytes.data(), call.out.bytes.size());
    return reply(CallStatus::returned, out.bytes);
}

/// Nobody reads what the thousandth call prints, and forgotten prints should
/// not cost the time and the space of all calls: of many, the first ones print,
/// the streams then fall silent, and what stdio prints is overwritten.
class FewPrints {
public:
    void before_call() {
        constexpr std::uint32_t calls_that_print = 100, step = 64;
        const std::uint32_t k = calls_++;
        if (k < calls_that_print || (k - calls_that_print) % step != 0) return;
        std::fflush(stdout);
        if (k > calls_that_print) {
            ::lseek(STDOUT_FILENO, end_, SEEK_SET);
            return;
        }
        end_ = ::lseek(STDOUT_FILENO, 0, SEEK_CUR);
        for (std::ostream* stream : {&std::cout, &std::cerr, &std::clog})
            stream->setstate(std::ios::failbit);
    }

private:
    std::uint32_t calls_ = 0;
    off_t end_ = 0;
};

/// Many calls, without a conversation between them.
bool answer_many(const Entry& entry, Reader& in, const WorkerTables& tables,
                 FewPrints& prints) {
    Writer trace, results;
    const auto n = get<std::uint32_t>(in);
    for (std::uint32_t k = 0; k < n; ++k) {
        prints.before_call();
        WorkerCall call{Reader(in.take(in.count(1))), {}, tables};
        if (const auto sent = failed(entry, call)) return *sent;
        put(results, running.request.nonce);
        put(results,
            call.walked != nullptr ? call.walked->reads() : std::int64_t{0});
        put(results, call.out.bytes);
        if (k + 1 == n) trace = trace_of(call);
        running.call = nullptr;
    }
    return reply(CallStatus::returned, trace.bytes + results.bytes);
}

void take_new_tables(Reader& in, WorkerTables& tables) {
    const auto n = get<std::uint32_t>(in);
    for (std::uint32_t k = 0; k < n; ++k) {
        const auto id = get<std::uint64_t>(in);
        const bool is_copies = get<bool>(in);
        tables.insert_or_assign(
            id, is_copies ? table_of(get<Copies>(in)) : get<HalfEdgeTable>(in));
    }
}

/// The submission's entry, or null with the loader's complaint in `why`.
const Entry* load(const std::string& submission, std::string& why) {
    void* object = ::dlopen(submission.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* entry =
        object != nullptr ? ::dlsym(object, "course_entry") : nullptr;
    if (entry == nullptr) {
        const char* text = ::dlerror();
        why = text != nullptr ? text : "no entry";
    }
    return static_cast<const Entry*>(entry);
}

}  // namespace

void serve_calls(const std::string& submission, int channel) {
    rlimit stack{};
    ::getrlimit(RLIMIT_STACK, &stack);
    const char here = 0;
    running.channel = channel;
    running.stack_top = &here;
    running.stack_size = static_cast<std::size_t>(stack.rlim_cur);
    catch_crashes();

    std::string why;
    const Entry* entry = load(submission, why);
    WorkerTables tables;
    FewPrints prints;
    std::string body;
    while (read_all(channel, &running.request, sizeof running.request)) {
        body.resize(running.request.length);
        if (!read_all(channel, body.data(), body.size())) return;
        if (entry == nullptr) {
            reply(CallStatus::not_loaded, encode(why));
            return;
        }
        WorkerCall call{Reader(body), {}, tables};
        take_new_tables(call.in, tables);
        bool sent = false;
        try {
            sent = running.request.status == CallStatus::many
                       ? answer_many(*entry, call.in, tables, prints)
                       : answer(*entry, call);
        } catch (const std::bad_alloc&) {  // the results are too many
            sent = reply(CallStatus::out_of_memory, trace_of(call).bytes);
        }
        std::fflush(stdout);  // so that the judge can show what was printed
        if (!sent) return;
    }
}

}  // namespace course
