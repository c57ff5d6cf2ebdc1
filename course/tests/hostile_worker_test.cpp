// The judge's side against a worker that breaks every rule. The test plays the
// launcher and the worker in threads of its own; whatever they do, a case ends
// in a verdict and the next case works with a new worker.
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <thread>

#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/runner/client.h"
#include "course/runner/proxy.h"

using namespace course;

namespace {

/// What a worker does with its channel, from start to end.
using Behaviour = std::function<void(int channel)>;

struct Asked {
    FrameHead head{};
    std::string body;
};

/// The next request; none when the judge has hung up.
std::optional<Asked> request(int channel) {
    Asked asked;
    if (!read_all(channel, &asked.head, sizeof asked.head)) return {};
    asked.body.resize(asked.head.length);
    if (!read_all(channel, asked.body.data(), asked.body.size())) return {};
    return asked;
}

void send_bytes(int channel, std::string_view bytes) {
    const auto until = Clock::now() + std::chrono::seconds(20);
    (void)send_all(channel, bytes, until);
}

template <class T>
std::string raw(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string trace(std::int64_t reads, const std::vector<std::int32_t>& visits) {
    return encode(reads) + encode(visits);
}

std::string reply(const Asked& asked, CallStatus status,
                  const std::string& body) {
    return raw(FrameHead{reply_magic, status, body.size(), asked.head.nonce}) +
           body;
}

/// Answers as it should: 4 to everything, from one read of row 2.
void honest(int channel) {
    while (const auto asked = request(channel))
        send_bytes(channel, reply(*asked, CallStatus::returned,
                                  trace(1, {2, 30}) + encode(4)));
}

/// Answers the first request with these bytes.
Behaviour sends(std::function<std::string(const Asked&)> bytes) {
    return [bytes = std::move(bytes)](int channel) {
        if (const auto asked = request(channel))
            send_bytes(channel, bytes(*asked));
        while (request(channel)) {
        }
    };
}

Behaviour replies(CallStatus status, const std::string& body) {
    return sends(
        [=](const Asked& asked) { return reply(asked, status, body); });
}

/// The launcher: workers are threads. The first one behaves as the test says,
/// all others are honest.
class FakeLauncher {
public:
    FakeLauncher(Behaviour first, int status, int user_ms)
        : first_(std::move(first)), status_(status), user_ms_(user_ms) {
        DescriptorPair ends = socket_pair();
        judge_end_ = std::move(ends.first);
        control_ = std::move(ends.second);
        thread_ = std::thread([this] { serve(); });
    }
    FakeLauncher(const FakeLauncher&) = delete;
    FakeLauncher& operator=(const FakeLauncher&) = delete;
    ~FakeLauncher() {
        ::shutdown(control_.get(), SHUT_RDWR);
        thread_.join();
        end_worker();
    }

    Descriptor judge_end() { return std::move(judge_end_); }
    int workers() const { return workers_; }

private:
    void tell(Event event, int status = 0) {
        const LauncherEvent e{event, generation_, status, user_ms_, 0};
        send_bytes(control_.get(), raw(e));
    }

    void start(std::vector<Descriptor>& passed) {
        REQUIRE(passed.size() == 2);
        end_worker();
        channel_ = std::move(passed[0]);
        const Behaviour behaviour = workers_++ == 0 ? first_ : honest;
        worker_ = std::thread([this, behaviour] {
            behaviour(channel_.get());
            // A process that ends closes its channel and is reported.
            ::shutdown(channel_.get(), SHUT_RDWR);
            if (!ended_.exchange(true)) tell(Event::ended, status_);
        });
        tell(Event::started);
    }

    void end_worker() {
        if (!worker_.joinable()) return;
        ::shutdown(channel_.get(), SHUT_RDWR);
        worker_.join();
    }

    void serve() {
        LauncherOrder order{};
        std::vector<Descriptor> passed;
        while (read_all(control_.get(), &order, sizeof order, &passed)) {
            if (order.order == Order::start_worker) {
                generation_ = order.generation;
                ended_ = false;
                start(passed);
            } else {
                end_worker();
            }
            passed.clear();
        }
    }

    Behaviour first_;
    int status_;
    int user_ms_;
    Descriptor judge_end_, control_, channel_;
    std::thread thread_, worker_;
    std::atomic<std::uint32_t> generation_ = 0;
    std::atomic<bool> ended_ = false;
    std::atomic<int> workers_ = 0;
};

Limits short_limits() {
    Limits limits;
    limits.call_ms = 300;
    limits.later_call_ms = 100;
    limits.reply_kib = 1024;
    return limits;
}

/// How one call of a case ended.
struct Outcome {
    std::optional<int> value;
    std::optional<Verdict> verdict;
    std::string why;
};

/// A judge with one submission that behaves so.
class Judge {
public:
    explicit Judge(Behaviour first, int status = 0,
                   Limits limits = short_limits(), int user_ms = 0)
        : launcher_(std::move(first), status, user_ms),
          client_(launcher_.judge_end(), limits) {
        Client::set_current(&client_);
        client_.on_failure = [this](Verdict verdict, const std::string& why) {
            CHECK_FALSE(last_.verdict.has_value());  // once for each call
            last_.verdict = verdict;
            last_.why = why;
        };
    }
    Judge(const Judge&) = delete;
    Judge& operator=(const Judge&) = delete;
    ~Judge() { Client::set_current(nullptr); }

    /// One call on the slide mesh, within a running case.
    template <class R = int>
    Outcome call() {
        last_ = {};
        try {
            const R got = remote_call<R>("f", slide_.he, 4);
            if constexpr (std::is_same_v<R, int>) last_.value = got;
        } catch (const WorkerFailed&) {
            CHECK(last_.verdict.has_value());
        }
        return last_;
    }

    /// A case of one call.
    Outcome run_case() {
        client_.begin_case();
        const Outcome outcome = call();
        client_.end_case();
        return outcome;
    }

    /// What was recorded since the last call began.
    const Outcome& outcome() const { return last_; }
    Client& client() { return client_; }
    const Fixture& slide() const { return slide_; }
    int workers() const { return launcher_.workers(); }

private:
    FakeLauncher launcher_;
    Client client_;
    Fixture slide_ = zoo::slide();
    Outcome last_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The first case ends in this verdict, the second gets its answer.
void check_verdict(const Behaviour& behaviour, Verdict expected,
                   const std::string& words, int status = 0) {
    Judge judge(behaviour, status);
    const auto start = Clock::now();
    const Outcome outcome = judge.run_case();
    CHECK(outcome.verdict == expected);
    INFO(outcome.why);
    CHECK(contains(outcome.why, words));
    CHECK(Clock::now() - start < std::chrono::seconds(10));
    const Outcome next = judge.run_case();
    CHECK(next.value == 4);
    CHECK(judge.workers() == 2);
}

}  // namespace

TEST_CASE("an honest worker answers, call after call, in one process") {
    Judge judge(honest);
    judge.client().begin_case();
    CHECK(judge.call().value == 4);
    CHECK(judge.call().value == 4);
    CHECK(judge.client().last_call().reads == 1);
    CHECK(judge.client().last_call().walk.at(0) == Visit{2, 30});
    judge.client().end_case();
    CHECK(judge.workers() == 1);
}

TEST_CASE("a reply to another question is refused") {
    const auto wrong = [](std::uint32_t magic, std::uint64_t change) {
        return sends([=](const Asked& asked) {
            const std::string body = trace(0, {}) + encode(4);
            return raw(FrameHead{magic, CallStatus::returned, body.size(),
                                 asked.head.nonce ^ change}) +
                   body;
        });
    };
    const std::string words = "no answer to the question";
    check_verdict(wrong(request_magic, 0), Verdict::run_time_error, words);
    check_verdict(wrong(0, 0), Verdict::run_time_error, words);
    check_verdict(wrong(reply_magic, 1), Verdict::run_time_error, words);
    check_verdict(sends([](const Asked&) { return std::string(500, 'x'); }),
                  Verdict::run_time_error, words);
}

TEST_CASE("bytes that nobody asked for are forbidden") {
    // The second call finds what was sent after the first reply.
    Judge judge(sends([](const Asked& asked) {
        return reply(asked, CallStatus::returned, trace(0, {}) + encode(4)) +
               "more";
    }));
    judge.client().begin_case();
    CHECK(judge.call().value == 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(judge.call().verdict == Verdict::forbidden_operation);
    judge.client().end_case();
    CHECK(judge.run_case().value == 4);
}

TEST_CASE("a reply that was sent before its question is never taken") {
    const std::string body = trace(0, {}) + encode(4);
    const std::string guess =
        raw(FrameHead{reply_magic, CallStatus::returned, body.size(), 0}) +
        body;
    Judge judge([guess](int channel) {
        send_bytes(channel, guess);
        while (request(channel)) {
        }
    });
    const Outcome outcome = judge.run_case();
    CHECK_FALSE(outcome.value.has_value());
    REQUIRE(outcome.verdict.has_value());
    CHECK((*outcome.verdict == Verdict::forbidden_operation ||
           *outcome.verdict == Verdict::run_time_error));
    CHECK(judge.run_case().value == 4);
}

TEST_CASE("half a reply is an end of time, or an end of the program") {
    const auto cut = [](const Asked& asked) {
        const std::string whole =
            reply(asked, CallStatus::returned, trace(0, {}) + encode(4));
        return whole.substr(0, whole.size() - 1);
    };
    check_verdict(sends(cut), Verdict::time_limit_exceeded, "no answer");
    check_verdict(
        sends([](const Asked& asked) {
            return reply(asked, CallStatus::returned, "").substr(0, 5);
        }),
        Verdict::time_limit_exceeded, "no answer");
    check_verdict(
        [cut](int channel) {
            if (const auto asked = request(channel))
                send_bytes(channel, cut(*asked));
        },
        Verdict::run_time_error, "exit(0)");
}

TEST_CASE("a reply longer than the limit is refused by its length alone") {
    // The limit, what table, id, budget and start allow beside it, and one
    // more.
    const std::uint64_t one_too_many =
        (std::uint64_t{1} << 20) +
        2 * sizeof(HalfEdge) * zoo::slide().he.rows().size() +
        4 * (2 * sizeof(std::uint64_t) + sizeof(int)) + 1;
    for (const std::uint64_t length :
         {one_too_many, std::uint64_t{1} << 40,
          std::numeric_limits<std::uint64_t>::max()})
        check_verdict(
            sends([=](const Asked& asked) {
                return raw(FrameHead{reply_magic, CallStatus::returned, length,
                                     asked.head.nonce});
            }),
            Verdict::memory_limit_exceeded, "larger than 1024 KiB");
}

TEST_CASE("a length that is promised and not sent ends with the time") {
    check_verdict(
        sends([](const Asked& asked) {
            return raw(FrameHead{reply_magic, CallStatus::returned,
                                 std::uint64_t{1} << 20, asked.head.nonce});
        }),
        Verdict::time_limit_exceeded, "no answer");
}

TEST_CASE("a worker that never answers runs out of time") {
    check_verdict(sends([](const Asked&) { return std::string(); }),
                  Verdict::time_limit_exceeded, "a loop that does not end");
}

TEST_CASE("a reply that comes byte by byte has the same limit") {
    check_verdict(
        [](int channel) {
            const auto asked = request(channel);
            if (!asked) return;
            const std::string whole =
                reply(*asked, CallStatus::returned, trace(0, {}) + encode(4));
            for (const char c : whole) {
                send_bytes(channel, std::string(1, c));
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
            }
        },
        Verdict::time_limit_exceeded, "no answer");
}

TEST_CASE("a worker that does not read its requests runs out of time") {
    // A table too large for the socket's buffer: the judge must not block.
    std::atomic<bool> over = false;
    Judge judge([&over](int) {
        while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    });
    const HalfEdgeTable large(std::vector<HalfEdge>(1'000'000));
    std::optional<Verdict> verdict;
    judge.client().on_failure = [&](Verdict v, const std::string&) {
        verdict = v;
    };
    judge.client().begin_case();
    CHECK_THROWS_AS(remote_call<int>("f", large, 4), WorkerFailed);
    CHECK(verdict == Verdict::time_limit_exceeded);
    over = true;
    judge.client().end_case();
}

TEST_CASE("a worker that ends says how") {
    const Behaviour ends = [](int channel) { (void)request(channel); };
    check_verdict(ends, Verdict::run_time_error, "exit(0)", 0);
    check_verdict(ends, Verdict::run_time_error, "exit(3)", 3 << 8);
    check_verdict(ends, Verdict::run_time_error, "segmentation", SIGSEGV);
    check_verdict(ends, Verdict::run_time_error, "aborted", SIGABRT);
    check_verdict(ends, Verdict::forbidden_operation, "not allowed", SIGSYS);
    check_verdict(ends, Verdict::run_time_error, "printed more", SIGXFSZ);
    check_verdict(ends, Verdict::time_limit_exceeded, "no answer", SIGXCPU);
    check_verdict(ends, Verdict::memory_limit_exceeded, "memory", SIGKILL);
    check_verdict(ends, Verdict::run_time_error, "signal 64", 64);
}

TEST_CASE("a worker that hangs up and lives on is a run-time error") {
    check_verdict(
        [](int channel) {
            (void)request(channel);
            ::shutdown(channel, SHUT_RDWR);
            std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        },
        Verdict::run_time_error, "closed its conversation");
}

TEST_CASE("a worker that is gone before the first call is noticed") {
    check_verdict([](int) {}, Verdict::run_time_error, "exit(0)");
}

TEST_CASE("negative reads count as none") {
    for (const std::int64_t reads :
         {std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()}) {
        Judge judge(
            replies(CallStatus::returned, trace(reads, {}) + encode(4)));
        const std::int64_t before = judge.slide().he.reads_left();
        CHECK(judge.run_case().value == 4);
        CHECK(judge.client().last_call().reads == 0);
        CHECK(judge.slide().he.reads_left() == before);
    }
}

TEST_CASE("more reads than there can be use up the budget and no more") {
    Judge judge(replies(
        CallStatus::returned,
        trace(std::numeric_limits<std::int64_t>::max(), {}) + encode(4)));
    CHECK(judge.run_case().value == 4);
    CHECK(judge.slide().he.reads_left() == 0);
}

TEST_CASE("of a walk of a million rows that do not exist, 64 are kept") {
    const std::vector<std::int32_t> walk(100'000, -7);
    Judge judge(
        replies(CallStatus::returned, trace(1'000'000, walk) + encode(4)));
    CHECK(judge.run_case().value == 4);
    CHECK(judge.client().last_call().walk.size() == 64);
}

TEST_CASE("a trace of an odd number of integers loses the last one") {
    Judge judge(replies(CallStatus::returned, trace(1, {1, 2, 3}) + encode(4)));
    CHECK(judge.run_case().value == 4);
    CHECK(judge.client().last_call().walk.size() == 1);
}

TEST_CASE("a reply that does not decode is a run-time error") {
    const std::string words = "broke its conversation";
    for (const std::string& body :
         {std::string(), std::string("short"), trace(0, {}),
          trace(0, {}) + "abc", trace(0, {}) + encode(4) + "x",
          encode(std::int64_t{0}) + encode(std::uint64_t{1} << 61)})
        check_verdict(replies(CallStatus::returned, body),
                      Verdict::run_time_error, words);
}

TEST_CASE("a list whose count is a lie is a run-time error") {
    Judge judge(replies(CallStatus::returned,
                        trace(0, {}) + encode(std::uint64_t{1} << 60)));
    judge.client().begin_case();
    CHECK(judge.call<std::vector<int>>().verdict == Verdict::run_time_error);
    judge.client().end_case();
    CHECK(judge.run_case().value == 4);
}

TEST_CASE("a status that does not exist is a run-time error") {
    for (const std::uint32_t status : {7U, 77U, ~0U})
        check_verdict(
            replies(static_cast<CallStatus>(status), trace(0, {}) + encode(4)),
            Verdict::run_time_error, "status is unknown");
}

TEST_CASE("what the worker says of a failed call becomes its verdict") {
    const std::string text = trace(1, {1, 2}) + encode(std::string("because"));
    check_verdict(replies(CallStatus::out_of_table, text),
                  Verdict::run_time_error, "because");
    check_verdict(replies(CallStatus::too_many_reads, text),
                  Verdict::time_limit_exceeded, "because");
    check_verdict(replies(CallStatus::out_of_memory, trace(0, {})),
                  Verdict::memory_limit_exceeded, "memory");
}

TEST_CASE("failed calls without their text are run-time errors") {
    for (const CallStatus status :
         {CallStatus::out_of_table, CallStatus::too_many_reads,
          CallStatus::threw, CallStatus::not_loaded}) {
        Judge judge(replies(status, ""));
        CHECK(judge.run_case().verdict == Verdict::run_time_error);
    }
}

TEST_CASE("bytes after the text of a failed call are a run-time error") {
    const std::string text = encode(std::string("because"));
    for (const CallStatus status :
         {CallStatus::out_of_table, CallStatus::too_many_reads})
        check_verdict(replies(status, trace(0, {}) + text + "x"),
                      Verdict::run_time_error, "trailing");
    check_verdict(replies(CallStatus::threw, trace(0, {}) + text + text + "x"),
                  Verdict::run_time_error, "trailing");
    check_verdict(replies(CallStatus::not_loaded, text + "x"),
                  Verdict::run_time_error, "trailing");
}

TEST_CASE("a failed call with an empty text still has a reason") {
    check_verdict(
        replies(CallStatus::out_of_table, trace(0, {}) + encode(std::string())),
        Verdict::run_time_error, "no reason");
}

TEST_CASE("a text of the submission is cut before it fills a report") {
    Judge judge(replies(CallStatus::out_of_table,
                        trace(0, {}) + encode(std::string(900'000, 'x'))));
    CHECK(judge.run_case().why.size() <= 4096);
}

TEST_CASE("an exception of the student is thrown here, by its type") {
    const auto thrown = [](const char* type) {
        return replies(CallStatus::threw, trace(0, {}) +
                                              encode(std::string(type)) +
                                              encode(std::string("why")));
    };
    const auto throws_as = [&](const char* type, auto&& check) {
        Judge judge(thrown(type));
        judge.client().begin_case();
        check([&] { (void)judge.call(); });
        judge.client().end_case();
        CHECK(judge.run_case().value == 4);
    };
    throws_as("std::out_of_range",
              [](auto f) { CHECK_THROWS_AS(f(), std::out_of_range); });
    throws_as("std::invalid_argument",
              [](auto f) { CHECK_THROWS_AS(f(), std::invalid_argument); });
    throws_as("int", [](auto f) { CHECK_THROWS_AS(f(), StudentException); });
    // Not ours to throw, whatever the worker calls it.
    throws_as("course::WorkerFailed",
              [](auto f) { CHECK_THROWS_AS(f(), StudentException); });
}

TEST_CASE("a forged account of a crash is read within its bounds") {
    Crash crash{};
    crash.signal = 1 << 30;
    crash.visit_count = std::numeric_limits<std::int32_t>::max();
    const auto forged = [](const std::string& body) {
        return [body](int channel) {
            if (const auto asked = request(channel))
                send_bytes(channel, reply(*asked, CallStatus::crashed, body));
        };
    };
    check_verdict(forged(raw(crash)), Verdict::run_time_error, "signal");
    crash.visit_count = -5;
    check_verdict(forged(raw(crash)), Verdict::run_time_error, "signal");
    crash.stack_overflow = 1;
    check_verdict(forged(raw(crash)), Verdict::run_time_error, "stack");
    crash.out_of_memory = 1;
    check_verdict(forged(raw(crash)), Verdict::memory_limit_exceeded, "memory");
    check_verdict(forged("too short"), Verdict::run_time_error, "exit(0)");
}

TEST_CASE("calls that were asked for ahead get the answers to their own") {
    const auto result = [](const Asked& asked, int value) {
        return encode(asked.head.nonce) + encode(std::int64_t{7}) +
               encode(encode(value));
    };
    const auto many = [](const std::function<std::string(const Asked&)>& all) {
        return sends([all](const Asked& asked) {
            return reply(asked, CallStatus::returned,
                         trace(0, {}) + all(asked));
        });
    };
    Judge judge(many([&](const Asked& asked) {
        return result(asked, 30) + result(asked, 44);
    }));
    judge.client().begin_case();
    judge.client().ask_ahead(judge.slide().he, {3, 4});
    CHECK(judge.call().value == 44);  // calls with 4
    CHECK(judge.client().last_call().reads == 7);
    judge.client().end_case();
    CHECK(judge.workers() == 1);
    using Results = std::function<std::string(const Asked&)>;
    const std::vector<Results> wrong = {
        [](const Asked&) { return std::string(); },
        [&](const Asked& asked) { return result(asked, 1); },
        [&](const Asked& asked) {
            return result(asked, 1) + result(asked, 2) + result(asked, 3);
        },
        [&](const Asked& asked) {
            Asked changed;
            changed.head.nonce = asked.head.nonce ^ 1;
            return result(changed, 1) + result(changed, 2);
        }};
    for (const Results& results : wrong) {
        Judge hostile(many(results));
        hostile.client().begin_case();
        hostile.client().ask_ahead(hostile.slide().he, {3, 4});
        // Forgotten; the next worker is asked for this one alone.
        CHECK(hostile.call().value == 4);
        CHECK(hostile.workers() == 2);
        hostile.client().end_case();
    }
    Judge hostile(many([&](const Asked& asked) {
        return result(asked, 1) + encode(asked.head.nonce) +
               encode(std::int64_t{0}) + encode(std::string("x"));
    }));
    hostile.client().begin_case();
    hostile.client().ask_ahead(hostile.slide().he, {3, 4});
    const Outcome outcome = hostile.call();
    CHECK(outcome.verdict == Verdict::run_time_error);
    CHECK(contains(outcome.why, "broke its conversation"));
    hostile.client().end_case();
}

TEST_CASE("where asking ahead fails, a fresh worker is asked one by one") {
    const std::vector<Behaviour> failing = {
        replies(CallStatus::too_many_reads,
                trace(9, {}) + encode(std::string("because"))),
        replies(CallStatus::threw, trace(0, {}) +
                                       encode(std::string("std::logic_error")) +
                                       encode(std::string("no"))),
        [](int channel) { (void)request(channel); },  // ends itself
        [](int channel) {                             // never answers
            while (request(channel)) {
            }
        }};
    for (const Behaviour& behaviour : failing) {
        Judge judge(behaviour);
        judge.client().begin_case();
        judge.client().ask_ahead(judge.slide().he, {3, 4});
        CHECK(judge.call().value == 4);
        CHECK(judge.call().value == 4);
        CHECK(judge.workers() == 2);
        judge.client().end_case();
        // Who failed once is asked one by one in later cases, too.
        judge.client().begin_case();
        judge.client().ask_ahead(judge.slide().he, {3, 4});
        CHECK(judge.call().value == 4);
        judge.client().end_case();
    }
}

TEST_CASE("a failed check shows the walk of a call that was answered ahead") {
    const auto both = [](int channel) {
        if (const auto asked = request(channel))
            send_bytes(channel,
                       reply(*asked, CallStatus::returned,
                             trace(0, {}) + encode(asked->head.nonce) +
                                 encode(std::int64_t{7}) + encode(encode(44))));
        honest(channel);
    };
    Judge judge(both);
    judge.client().begin_case();
    judge.client().ask_ahead(judge.slide().he, {4});
    CHECK(judge.call().value == 44);
    CHECK(judge.client().last_call().walk.empty());
    judge.client().walk_again();
    CHECK(judge.client().last_call().walk.at(0) == Visit{2, 30});
    judge.client().end_case();
}

TEST_CASE("a case fails whose calls took more time than they have in all") {
    using std::chrono::milliseconds;
    constexpr int used_ms = 400;
    for (const auto& [most, verdict] :
         {std::pair{milliseconds(399),
                    std::optional(Verdict::time_limit_exceeded)},
          std::pair{milliseconds(400), std::optional<Verdict>()}}) {
        Judge judge(honest, 0, short_limits(), used_ms);
        judge.client().begin_case();
        judge.client().limit_cpu(most);
        CHECK(judge.call().value == 4);
        judge.client().end_case();
        CHECK(judge.outcome().verdict == verdict);
    }
}

TEST_CASE("what one worker says of loading holds for its case only") {
    // The text may hold what the case asked, and other cases may be shown.
    Judge judge(replies(CallStatus::not_loaded, encode(std::string("no f"))));
    const Outcome outcome = judge.run_case();
    CHECK(outcome.verdict == Verdict::compile_error);
    CHECK(outcome.why == "no f");
    CHECK(judge.run_case().value == 4);
    CHECK(judge.workers() == 2);
}

TEST_CASE("after a failure the case makes no more calls") {
    Judge judge(replies(CallStatus::out_of_table,
                        trace(0, {}) + encode(std::string("because"))));
    judge.client().begin_case();
    CHECK(judge.call().verdict == Verdict::run_time_error);
    // Refused at once, and not recorded again.
    CHECK_THROWS_AS(judge.client().begin_call(), WorkerFailed);
    judge.client().end_case();
    CHECK(judge.workers() == 1);
}

TEST_CASE("who runs out of time again and again is not asked any more") {
    Limits limits = short_limits();
    limits.max_timeouts = 1;
    Judge judge(sends([](const Asked&) { return std::string(); }), 0, limits);
    CHECK(judge.run_case().verdict == Verdict::time_limit_exceeded);
    const Outcome next = judge.run_case();
    CHECK(next.verdict == Verdict::time_limit_exceeded);
    CHECK(contains(next.why, "not run"));
    CHECK(judge.workers() == 1);
}

TEST_CASE("slow answers do not outlast the limit of all cases together") {
    Limits limits = short_limits();
    limits.run_ms = 30;
    Judge judge(honest, 0, limits);
    CHECK(judge.run_case().value == 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(40));
    const Outcome late = judge.run_case();
    CHECK(late.verdict == Verdict::time_limit_exceeded);
    CHECK(contains(late.why, "not run"));
}

TEST_CASE("a launcher that is gone is a fault of the grader") {
    DescriptorPair control = socket_pair();
    control.second.reset();
    Client client(std::move(control.first), short_limits());
    std::optional<Verdict> verdict;
    client.on_failure = [&](Verdict v, const std::string&) { verdict = v; };
    for (int k = 0; k < 2; ++k) {
        client.begin_case();
        CHECK_THROWS_AS(client.begin_call(), WorkerFailed);
        CHECK(verdict == Verdict::grader_fault);
        client.end_case();
    }
}

TEST_CASE("a launcher that goes with its worker is a fault of the grader") {
    DescriptorPair control = socket_pair();
    // Starts one worker and is gone, with all that it has.
    std::thread launcher([end = std::move(control.second)]() mutable {
        LauncherOrder order{};
        std::vector<Descriptor> passed;
        if (!read_all(end.get(), &order, sizeof order, &passed)) return;
        send_bytes(end.get(), raw(LauncherEvent{Event::started,
                                                order.generation, 0, 0, 0}));
        (void)request(passed.at(0).get());
        end.reset();
    });
    Client client(std::move(control.first), short_limits());
    Client::set_current(&client);
    std::optional<Verdict> verdict;
    client.on_failure = [&](Verdict v, const std::string&) { verdict = v; };
    client.begin_case();
    const Fixture slide = zoo::slide();
    CHECK_THROWS_AS(remote_call<int>("f", slide.he, 4), WorkerFailed);
    CHECK(verdict == Verdict::grader_fault);
    client.end_case();
    launcher.join();
    Client::set_current(nullptr);
}
