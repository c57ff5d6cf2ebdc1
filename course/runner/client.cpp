#include "course/runner/client.h"
#include "course/runner/signal_text.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <random>

namespace course {

namespace {

Client* the_client = nullptr;

// A launcher that does not answer for so long is broken, or the machine is:
// a fault of the grader, never of the submission.
constexpr std::chrono::seconds launcher_patience{20};

/// A request for many calls failed: that is forgotten, they are asked singly.
struct AskedInVain {};

/// The launcher lives, as far as is known, but says nothing.
struct LauncherSilent : SystemError {
    using SystemError::SystemError;
};

// Tables up to this size are compared row by row before they are taken for one
// that the worker already has; of larger ones a sample.
constexpr std::size_t small_table = 4096;
constexpr std::size_t most_tables = 64;

bool same_rows(const std::vector<HalfEdge>& sent,
               const std::vector<HalfEdge>& now) {
    if (sent.size() != now.size()) return false;
    if (now.size() <= small_table) return sent == now;
    const std::size_t step = now.size() / 64;
    for (std::size_t k = 0; k < now.size(); k += step)
        if (sent[k] != now[k]) return false;
    return true;
}

std::uint64_t nonce() {
    static std::random_device source;
    return std::uint64_t{source()} << 32 | source();
}

std::string crash_text(const Crash& crash) {
    std::string text = crash.stack_overflow != 0 ? stack_overflow_text
                                                 : signal_text(crash.signal);
    const int n = std::clamp(crash.visit_count, 0, 64);
    if (n > 0)
        text += fmt::format("; the last use of the table was he[{}] at line {}",
                            crash.visits[n - 1][0], crash.visits[n - 1][1]);
    return text;
}

std::string out_of_memory_text(const Limits& limits) {
    return fmt::format("the program asked for more than {} MiB of memory",
                       limits.memory_mib);
}

/// A text for messages. Catch2 needs half a minute to print 50 MB.
std::string text_from(Reader& in) {
    constexpr std::size_t longest = 4096;
    const std::size_t size = in.count(1);
    const std::string_view all = in.take(size);
    return std::string(all.substr(0, longest));
}

/// The last text of a reply.
std::string last_text_from(Reader& in) {
    std::string text = text_from(in);
    in.done();
    return text;
}

/// The student's exception as the same standard type, so that a suite can ask
/// for it by type.
[[noreturn]] void rethrow(const std::string& type, const std::string& text) {
    if (type == "std::invalid_argument") throw std::invalid_argument(text);
    if (type == "std::domain_error") throw std::domain_error(text);
    if (type == "std::out_of_range") throw std::out_of_range(text);
    if (type == "std::length_error") throw std::length_error(text);
    if (type == "std::logic_error") throw std::logic_error(text);
    if (type == "std::runtime_error") throw std::runtime_error(text);
    throw StudentException(type + ": " + text);
}

}  // namespace

Client::Client(Descriptor control, const Limits& limits)
    : control_(std::move(control)), limits_(limits) {
    begin_run();
}

void Client::begin_run() {
    run_end_ = Clock::now() + std::chrono::milliseconds(limits_.run_ms);
}

Client* Client::current() {
    return the_client;
}

void Client::set_current(Client* client) {
    the_client = client;
}

void Client::begin_case() {
    poisoned_ = is_trial_ = not_again_ = false;
    last_call_ = {};
    answered_.reset();
    output_.reset();
    is_strict_ = false;
    cpu_limit_ = std::chrono::milliseconds(was_endless_ ? limits_.later_cpu_ms
                                                        : limits_.cpu_ms);
    case_end_ = Clock::now() + std::chrono::milliseconds(limits_.case_ms);
}

void Client::limit_cpu(std::chrono::milliseconds most) {
    cpu_limit_ = most;
    is_strict_ = true;
}

void Client::send_as(const HalfEdgeTable& table, const Copies& copies) {
    for (const SentTable& sent : sent_)
        if (sent.copies == &copies) return;
    sent_.push_back({next_table_++, table.rows().data(), {}, 0, &copies});
}

void Client::end_case() {
    channel_.reset();
    end_worker();
}

LauncherEvent Client::wait_for_event(Event wanted,
                                     std::chrono::milliseconds most) {
    const auto until = Clock::now() + most;
    for (;;) {
        std::string bytes;
        LauncherEvent event{};
        switch (receive_all(control_.get(), bytes, sizeof event, until)) {
            case Transfer::done:
                break;
            case Transfer::closed:
                throw SystemError("the sandbox is gone");
            case Transfer::timed_out:
                throw LauncherSilent("the sandbox does not answer");
        }
        std::memcpy(&event, bytes.data(), sizeof event);
        if (event.generation != generation_) continue;
        if (event.event == Event::not_started)
            throw SystemError(fmt::format("no worker could be started: {}",
                                          std::strerror(event.status)));
        if (event.event == wanted) return event;
    }
}

void Client::start_worker() {
    DescriptorPair ends = socket_pair();
    output_ = anonymous_file();
    channel_ = std::move(ends.first);
    Limits limits = limits_;
    limits.cpu_ms = static_cast<std::int32_t>(cpu_limit_.count());
    const LauncherOrder order{Order::start_worker, ++generation_, limits};
    const int passed[] = {ends.second.get(), output_.get()};
    const std::string_view bytes(reinterpret_cast<const char*>(&order),
                                 sizeof order);
    if (send_all(control_.get(), bytes, Clock::now() + launcher_patience,
                 passed) != Transfer::done)
        throw SystemError("the sandbox is gone");
    wait_for_event(Event::started, launcher_patience);
    alive_ = true;
    crash_.reset();
}

void Client::end_worker() {
    if (!alive_) return;
    alive_ = false;
    const LauncherOrder order{Order::end_worker, generation_, limits_};
    const std::string_view bytes(reinterpret_cast<const char*>(&order),
                                 sizeof order);
    if (send_all(control_.get(), bytes, Clock::now() + launcher_patience) !=
        Transfer::done)
        throw SystemError("the sandbox is gone");
    const LauncherEvent event = wait_for_event(Event::ended, launcher_patience);
    check_time(std::chrono::milliseconds(event.user_ms));
}

/// The calls were answered, but took more time than they have in all. Without
/// the system's, who may have much to do for who asks for memory.
void Client::check_time(std::chrono::milliseconds used) {
    if (!is_strict_ || poisoned_ || asking_ahead_ || used <= cpu_limit_ ||
        !on_failure)
        return;
    on_failure(
        Verdict::time_limit_exceeded,
        fmt::format("the calls of this case took {} ms; {} ms are enough "
                    "for them where the cost does not grow with the "
                    "mesh",
                    used.count(), cpu_limit_.count()));
}

Client::SentTable& Client::known_table(const HalfEdgeTable& table) {
    const std::vector<HalfEdge>& rows = table.rows();
    // Most calls are about the table that was sent last.
    for (auto sent = sent_.rbegin(); sent != sent_.rend(); ++sent) {
        if (sent->rows != rows.data() && rows.size() > small_table) continue;
        if (sent->copies != nullptr ? sent->rows == rows.data()
                                    : same_rows(sent->copy, rows))
            return *sent;
    }
    if (sent_.size() >= most_tables) sent_.pop_front();
    sent_.push_back({next_table_++, rows.data(), rows, 0, nullptr});
    return sent_.back();
}

void Client::add_table(Request& request, const HalfEdgeTable& table) {
    SentTable& known = known_table(table);
    if (known.generation != generation_) {
        known.generation = generation_;
        ++request.table_count;
        put(request.tables, known.id);
        put(request.tables, known.copies != nullptr);
        if (known.copies != nullptr)
            put(request.tables, *known.copies);
        else
            put(request.tables, table);
    }
    put(request.arguments, known.id);
    put(request.arguments,
        std::min(table.reads_left(), table.default_budget()));
    request.table_bytes += 2 * sizeof(HalfEdge) * table.rows().size();
    if (request.walked == nullptr) request.walked = &table;
}

Clock::time_point Client::deadline() const {
    // Honest calls take microseconds, and asking ahead may fail.
    constexpr int many_ms = 500;
    int most =
        timeouts_ == 0 && !is_trial_ ? limits_.call_ms : limits_.later_call_ms;
    if (asking_ahead_) most = std::min(most, many_ms);
    return std::min(case_end_, Clock::now() + std::chrono::milliseconds(most));
}

void Client::begin_call() {
    if (poisoned_) throw WorkerFailed{};
    if (!for_good_ && Clock::now() > run_end_)
        for_good_ = {
            Verdict::time_limit_exceeded,
            fmt::format("not run: the cases before took more than {} s",
                        limits_.run_ms / 1000.0)};
    if (for_good_) fail(for_good_->first, for_good_->second);
    if (alive_) return;
    try {
        start_worker();
    } catch (const SystemError& error) {
        for_good_ = {Verdict::grader_fault, error.what()};
        fail(for_good_->first, for_good_->second);
    }
}

void Client::ask_ahead(const HalfEdgeTable& he, std::vector<int> starts) {
    if (!one_by_one_) ahead_ = Ahead{&he, std::move(starts)};
}

// The arguments of f(he, i): id and budget of the table, start.
constexpr std::size_t table_argument = 2 * sizeof(std::uint64_t);

bool Client::is_ahead(const Request& request) const {
    return ahead_ && request.walked == ahead_->he &&
           request.arguments.bytes.size() == table_argument + sizeof(int);
}

/// One request for the next calls that were announced, with the table and the
/// budget of this one. Not for all: who answers wrong is told so soon.
void Client::fetch_ahead(const Request& request) {
    constexpr std::size_t most = 500;
    const std::size_t first = ahead_->asked;
    ahead_->asked = std::min(first + most, ahead_->starts.size());
    ahead_->table = request.arguments.bytes.substr(0, table_argument);
    ahead_->answers.clear();
    Request all = request;
    all.arguments = {};
    put(all.arguments, static_cast<std::uint32_t>(ahead_->asked - first));
    for (std::size_t k = first; k < ahead_->asked; ++k)
        put(all.arguments, ahead_->table + encode(ahead_->starts[k]));
    const std::string body = ask(CallStatus::many, all);
    Reader in(body);
    for (std::size_t k = first; k < ahead_->asked; ++k) {
        if (get<std::uint64_t>(in) != nonce_)
            malformed("it answers another question than that which was asked");
        const auto reads = get<std::int64_t>(in);
        ahead_->answers.push_back({reads, get<std::string>(in)});
    }
    in.done();
}

/// The answer for that start, if it was asked for and not yet given.
const Client::Answer* Client::find_ahead(int start) {
    const std::size_t first = ahead_->asked - ahead_->answers.size();
    for (std::size_t k = std::max(ahead_->next, first); k < ahead_->asked; ++k)
        if (ahead_->starts[k] == start) {
            ahead_->next = k + 1;
            return &ahead_->answers[k - first];
        }
    return nullptr;
}

std::optional<std::string> Client::answered_ahead(const Request& request) {
    const std::string_view arguments = request.arguments.bytes;
    const int start = decode<int>(arguments.substr(table_argument));
    const Answer* answer = nullptr;
    if (arguments.substr(0, table_argument) == ahead_->table)
        answer = find_ahead(start);
    if (answer == nullptr && ahead_->asked < ahead_->starts.size()) {
        asking_ahead_ = true;
        fetch_ahead(request);
        asking_ahead_ = false;
        answer = find_ahead(start);
    }
    if (answer == nullptr) return std::nullopt;
    last_call_.walk.clear();
    last_call_.reads = std::max<std::int64_t>(answer->reads, 0);
    request.walked->note_reads(last_call_.reads, {});
    answered_ = request;
    return answer->result;
}

/// After asking ahead has failed, in whatever way.
void Client::begin_again() {
    one_by_one_ = true;
    ahead_.reset();
    if (was_endless_)
        cpu_limit_ = std::min(cpu_limit_,
                              std::chrono::milliseconds(limits_.later_cpu_ms));
    end_case();
    asking_ahead_ = false;
    begin_call();
}

std::string Client::call(const std::function<Request()>& make) {
    const Request request = make();
    if (!is_ahead(request)) return ask(CallStatus::returned, request);
    try {
        if (auto answer = answered_ahead(request)) return *std::move(answer);
    } catch (const AskedInVain&) {
    } catch (const std::exception&) {  // the student's, or not decoded
    }
    if (!asking_ahead_) return ask(CallStatus::returned, request);
    begin_again();
    return ask(CallStatus::returned, make());
}

void Client::walk_again() {
    if (!answered_ || poisoned_ || !alive_) return;
    const auto tell = std::exchange(on_failure, nullptr);
    try {
        const Request again = *std::exchange(answered_, std::nullopt);
        ask(CallStatus::returned, again);
    } catch (const WorkerFailed&) {  // the check has failed already
    } catch (const std::exception&) {
    }
    on_failure = tell;
}

bool Client::try_again() {
    is_trial_ = true;
    if (not_again_ || for_good_) return false;
    try {
        if (poisoned_) end_case();
    } catch (const SystemError& error) {
        for_good_ = {Verdict::grader_fault, error.what()};
        return false;
    }
    poisoned_ = false;
    return true;
}

std::string Client::ask(CallStatus kind, const Request& request) {
    walked_ = request.walked;
    answered_.reset();
    // An honest answer is no larger than a few times what it is made from.
    reply_extra_ = request.table_bytes + 4 * request.arguments.bytes.size();
    if (has_input(channel_.get()))
        fail(Verdict::forbidden_operation,
             "the program wrote to the grader's channel before it was asked");
    nonce_ = nonce();
    FrameHead head{request_magic, kind, 0, nonce_};
    head.length = sizeof request.table_count + request.tables.bytes.size() +
                  request.arguments.bytes.size();
    const auto until = deadline();
    send(head, request, until);
    std::string body;
    const FrameHead reply = receive(head, body, until);
    return result_of(reply, body);
}

void Client::send(const FrameHead& head, const Request& request,
                  Clock::time_point until) {
    Writer frame;
    frame.raw(&head, sizeof head);
    put(frame, request.table_count);
    frame.bytes += request.tables.bytes;
    frame.bytes += request.arguments.bytes;
    switch (send_all(channel_.get(), frame.bytes, until)) {
        case Transfer::done:
            return;
        case Transfer::closed:
            worker_is_gone();
        case Transfer::timed_out:
            ran_out_of_time("the program does not take its input");
    }
}

FrameHead Client::receive(const FrameHead& request, std::string& body,
                          Clock::time_point until) {
    const auto take = [&](std::size_t size) {
        switch (receive_all(channel_.get(), body, size, until)) {
            case Transfer::done:
                return;
            case Transfer::closed:
                worker_is_gone();
            case Transfer::timed_out:
                ran_out_of_time("no answer");
        }
    };
    FrameHead reply{};
    take(sizeof reply);
    std::memcpy(&reply, body.data(), sizeof reply);
    if (reply.magic != reply_magic || reply.nonce != request.nonce)
        malformed("it is no answer to the question that was asked");
    const std::uint64_t most =
        (static_cast<std::uint64_t>(limits_.reply_kib) << 10) + reply_extra_;
    if (reply.length > most)
        fail(Verdict::memory_limit_exceeded,
             fmt::format("the result is larger than {} KiB", most >> 10));
    take(static_cast<std::size_t>(reply.length));
    return reply;
}

void Client::take_trace(Reader& in) {
    last_call_.reads = std::max<std::int64_t>(get<std::int64_t>(in), 0);
    const auto pairs = get<std::vector<std::int32_t>>(in);
    const std::size_t n = std::min<std::size_t>(pairs.size() / 2, 64);
    last_call_.walk.clear();
    for (std::size_t k = 0; k < n; ++k)
        last_call_.walk.push_back({pairs[2 * k], pairs[2 * k + 1]});
    if (walked_ != nullptr)
        walked_->note_reads(last_call_.reads, last_call_.walk);
}

void Client::note_crash(const std::string& body) {
    if (body.size() != sizeof(Crash)) return;
    crash_.emplace();
    std::memcpy(&*crash_, body.data(), sizeof(Crash));
    last_call_.walk.clear();
    last_call_.reads = std::clamp(crash_->visit_count, 0, 64);
    for (int k = 0; k < last_call_.reads; ++k)
        last_call_.walk.push_back({crash_->visits[k][0], crash_->visits[k][1]});
}

std::string Client::result_of(const FrameHead& reply, const std::string& body) {
    if (reply.status == CallStatus::crashed) {
        note_crash(body);
        worker_is_gone();
    }
    try {
        Reader in(body);
        if (reply.status == CallStatus::not_loaded && !loaded_)
            fail(Verdict::compile_error, last_text_from(in));
        loaded_ = true;
        take_trace(in);
        switch (reply.status) {
            case CallStatus::returned:
                return std::string(in.take(in.left()));
            case CallStatus::out_of_table:
                fail(Verdict::run_time_error, last_text_from(in));
            case CallStatus::too_many_reads:
                fail(Verdict::time_limit_exceeded, last_text_from(in));
            case CallStatus::out_of_memory:
                fail(Verdict::memory_limit_exceeded,
                     out_of_memory_text(limits_));
            case CallStatus::threw: {
                const std::string type = text_from(in);
                rethrow(type, last_text_from(in));
            }
            default:
                break;
        }
    } catch (const CodecError& error) {
        malformed(error.what());
    }
    malformed("its status is unknown");
}

std::string Client::printed() const {
    if (!output_) return "";
    std::string text(2048, '\0');
    const ssize_t n = ::pread(output_.get(), text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    return text;
}

void Client::fail(Verdict verdict, const std::string& why) {
    if (asking_ahead_) throw AskedInVain{};
    poisoned_ = true;
    not_again_ = not_again_ || verdict == Verdict::memory_limit_exceeded ||
                 verdict == Verdict::forbidden_operation;
    // A hostile worker may give an empty one.
    if (on_failure) on_failure(verdict, why.empty() ? "no reason given" : why);
    throw WorkerFailed{};
}

void Client::malformed(const std::string& why) {
    fail(Verdict::run_time_error,
         "the program broke its conversation with the grader: " + why);
}

void Client::ran_out_of_time(const std::string& why) {
    if (asking_ahead_) throw AskedInVain{};
    not_again_ = true;
    if (!is_trial_ && ++timeouts_ >= limits_.max_timeouts)
        for_good_ = {Verdict::time_limit_exceeded,
                     fmt::format("not run: the program ran out of time in {} "
                                 "cases before",
                                 timeouts_)};
    fail(Verdict::time_limit_exceeded,
         why + " within the limit of time: a loop that does not end?");
}

/// The worker has closed its channel or died: asks the launcher how.
void Client::worker_is_gone() {
    LauncherEvent event{};
    try {
        event = wait_for_event(Event::ended, std::chrono::milliseconds(1000));
    } catch (const LauncherSilent&) {
        fail(Verdict::run_time_error,
             "the program closed its conversation with the grader");
    } catch (const SystemError& error) {
        alive_ = false;
        for_good_ = {Verdict::grader_fault, error.what()};
        fail(for_good_->first, for_good_->second);
    }
    alive_ = false;
    const int status = event.status;
    if (crash_ && crash_->out_of_memory != 0)
        fail(Verdict::memory_limit_exceeded, out_of_memory_text(limits_));
    if (crash_) fail(Verdict::run_time_error, crash_text(*crash_));
    if (WIFEXITED(status))
        fail(Verdict::run_time_error,
             fmt::format("the program ended itself with exit({}) instead of "
                         "returning an answer",
                         WEXITSTATUS(status)));
    const int signal = WTERMSIG(status);
    if (signal == SIGSYS)
        fail(Verdict::forbidden_operation,
             "the program asked the system for something that is not allowed: "
             "a file, a process, the network or the like");
    if (signal == SIGXFSZ)
        fail(Verdict::run_time_error,
             fmt::format("the program printed more than {} KiB",
                         limits_.output_kib));
    if (signal == SIGPROF || signal == SIGXCPU ||
        (signal == SIGKILL &&
         event.cpu_us >=
             std::int64_t{1'000'000} * limits_.cpu_seconds - 100'000)) {
        one_by_one_ = true;
        if (!is_trial_) was_endless_ = true;
        ran_out_of_time("no answer");
    }
    if (signal == SIGKILL)
        fail(Verdict::memory_limit_exceeded,
             "the program was ended from outside: too much memory?");
    fail(Verdict::run_time_error, signal_text(signal));
}

}  // namespace course
