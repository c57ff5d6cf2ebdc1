// course_recorder SUBMISSION ORDER RECORDING: calls the function of a traced
// submission with one start after the other and records what it does with the
// table. Everything that the submission does ends with this process; a crash or
// a time limit ends one call, and what was recorded until then is kept.
#include <dlfcn.h>
#include <sys/time.h>
#include <unistd.h>

#include <fmt/format.h>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numeric>

#include "course/halfedge/table_errors.h"
#include "course/player/recorded_call.h"
#include "course/player/walk_entry.h"
#include "course/runner/exception_type.h"
#include "course/runner/set_limits.h"
#include "course/runner/signal_text.h"

// What gdb looks at: a breakpoint of it stands at the function, which is called
// before each walk; and how many events there are so far.
extern "C" {
[[gnu::noinline, gnu::used]] void course_walk_begins() {
    asm volatile("");
}
[[gnu::used]] const std::size_t* course_trace_size =
    &HalfEdgeTable::trace_size();
}

namespace course {

namespace {

// There is no other way to reach what a signal handler needs.
sigjmp_buf before_call;
volatile std::sig_atomic_t in_call = 0;
volatile std::sig_atomic_t stack_is_full = 0;
const char* stack_top = nullptr;
std::ptrdiff_t stack_size = 0;

void on_signal(int signal, siginfo_t* info, void*) {
    if (in_call == 0) ::_exit(1);
    in_call = 0;  // a second crash, on the way out, ends the process
    const auto depth = stack_top - static_cast<const char*>(info->si_addr);
    stack_is_full = signal == SIGSEGV && depth > stack_size - stack_size / 8 &&
                            depth < stack_size + stack_size / 8
                        ? 1
                        : 0;
    siglongjmp(before_call, signal);
}

void catch_signals() {
    static char handler_stack[1 << 16];
    stack_t stack{};
    stack.ss_sp = handler_stack;
    stack.ss_size = sizeof handler_stack;
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPROF})
        ::sigaction(signal, &action, nullptr);
}

/// After that much CPU time of this process comes SIGPROF; 0: never.
void set_timer(int ms) {
    const itimerval timer{{0, 0}, {ms / 1000, suseconds_t{1000} * (ms % 1000)}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

std::string text_of_end(int signal, int ms) {
    if (signal == SIGPROF)
        return fmt::format(
            "stopped after {} ms: a loop does not end, and reads no table", ms);
    return stack_is_full != 0 ? stack_overflow_text : signal_text(signal);
}

std::string text_of_exception(const char* what) {
    const std::string name = type_of_exception();
    return *what == '\0' ? "throws " + name
                         : fmt::format("throws {}: {:.4096}", name, what);
}

/// The call itself; what it throws is its outcome.
std::string call(const WalkEntry& entry, const WalkInput& input, int start,
                 WalkOutcome& outcome) {
    try {
        entry.call(input, start, outcome);
        return "";
    } catch (const OutOfTable& error) {
        return error.what();
    } catch (const TooManyReads& error) {
        return error.what();
    } catch (const std::bad_alloc&) {
        return "all memory that it may have is used up";
    } catch (const std::exception& error) {
        return text_of_exception(error.what());
    } catch (...) {
        return text_of_exception("");
    }
}

/// How much CPU time a call may take: what is traced takes longer than what is
/// checked; but once a call has run out of it, the next ones get little.
int time_for_call(int timeouts) {
    constexpr int times_slower = 4;
    return timeouts == 0 ? times_slower * Limits{}.cpu_ms
                         : Limits{}.later_cpu_ms;
}

RecordedCall record(const WalkEntry& entry, const WalkInput& input, int start,
                    std::uint64_t most, int& timeouts) {
    // Static: siglongjmp leaves them as they are.
    static WalkOutcome outcome;
    static RecordedCall recorded;
    static int ms;
    outcome = {};
    recorded = {};
    input.he.begin_call(input.he.default_budget(), start);
    course_walk_begins();
    input.he.start_trace(most);
    ms = time_for_call(timeouts);
    const int signal = sigsetjmp(before_call, 1);
    if (signal == 0) {
        in_call = 1;
        set_timer(ms);
        recorded.error = call(entry, input, start, outcome);
    } else {
        recorded.error = text_of_end(signal, ms);
        if (signal == SIGPROF) ++timeouts;
    }
    in_call = 0;
    set_timer(0);
    recorded.size = HalfEdgeTable::trace_size();
    recorded.events = input.he.stop_trace();
    recorded.call = std::move(outcome.call);
    if (recorded.error.empty()) recorded.result = std::move(outcome.result);
    return std::move(recorded);
}

Anchors anchors_of(const RecordOrder& order) {
    Anchors anchors;
    anchors.vertex.assign(order.mesh.positions.size(), -1);
    anchors.face.assign(static_cast<std::size_t>(order.mesh.faces.size()), -1);
    for (std::size_t i = order.rows.size(); i-- > 0;) {
        const HalfEdge& row = order.rows[i];
        anchors.vertex.at(static_cast<std::size_t>(row.vi)) =
            static_cast<int>(i);
        if (row.fi >= 0)
            anchors.face.at(static_cast<std::size_t>(row.fi)) =
                static_cast<int>(i);
    }
    return anchors;
}

std::vector<int> starts_of(StartKind kind, const RecordOrder& order) {
    if (kind == StartKind::none) return {-1};
    const bool at_vertex = kind == StartKind::vertex;
    const int n = at_vertex ? order.mesh.vertex_count()
                            : static_cast<int>(order.rows.size());
    for (const int start : order.starts)
        if (start < 0 || start >= n)
            throw std::runtime_error(
                fmt::format("start {} is none of the {} 0..{}", start,
                            at_vertex ? "vertices" : "half-edges", n - 1));
    if (!order.starts.empty()) return order.starts;
    std::vector<int> starts(static_cast<std::size_t>(n));
    std::iota(starts.begin(), starts.end(), 0);
    return starts;
}

const WalkEntry& load(const char* submission) {
    void* object = ::dlopen(submission, RTLD_NOW | RTLD_LOCAL);
    const void* entry =
        object == nullptr ? nullptr : ::dlsym(object, "course_walk_entry");
    if (entry == nullptr) throw std::runtime_error(::dlerror());
    return *static_cast<const WalkEntry*>(entry);
}

void run(char** argv) {
    std::ifstream in(argv[2], std::ios::binary);
    const auto order = decode<RecordOrder>(
        std::string(std::istreambuf_iterator<char>(in), {}));
    std::ofstream out(argv[3], std::ios::binary);
    const WalkEntry& entry = load(argv[1]);
    if (entry.call == nullptr)
        throw std::runtime_error("there is no rule that chooses its arguments");
    const WalkInput input{HalfEdgeTable(order.rows), order.mesh,
                          anchors_of(order)};
    const std::vector<int> starts = starts_of(entry.start, order);
    const auto write = [&](const std::string& bytes) {
        out << encode(std::uint64_t{bytes.size()}) << bytes << std::flush;
    };
    write(encode(static_cast<std::uint32_t>(entry.start)) + encode(starts));
    // Each call writes the table that it was given, and may copy it.
    const auto table_kib =
        static_cast<int>(order.rows.size() * sizeof(HalfEdge) >> 10) + 1;
    Limits limits;
    limits.cpu_seconds = 60;
    limits.output_kib =
        (1 << 16) + 2 * table_kib * static_cast<int>(starts.size());
    limits.memory_mib += 16 * table_kib >> 10;
    limits.cpu_ms = 60'000;
    set_limits(limits);
    const char here = 0;
    stack_top = &here;
    stack_size = std::ptrdiff_t{limits.stack_mib} << 20;
    catch_signals();
    int timeouts = 0;
    for (std::size_t k = order.done; k < starts.size(); ++k)
        write(encode(timeouts < limits.max_timeouts
                         ? record(entry, input, starts[k], order.most, timeouts)
                         : RecordedCall{"", "",
                                        "not called: the calls before it did "
                                        "not end"}));
}

}  // namespace

}  // namespace course

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs(
            "usage: course_recorder SUBMISSION.so ORDER RECORDING "
            "(started by lab)\n",
            stderr);
        return 2;
    }
    try {
        course::run(argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        std::fflush(stderr);
        ::_exit(3);
    }
    std::fflush(nullptr);
    ::_exit(0);  // no destructor of the submission runs
}
