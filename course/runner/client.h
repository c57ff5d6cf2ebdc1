// The judge's side of a submission: calls into a worker, one fresh worker per
// case, hard limits on time and size, and a record of what went wrong.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "course/halfedge/copies.h"
#include "course/runner/codec.h"
#include "course/runner/descriptors.h"
#include "course/runner/limits.h"
#include "course/runner/protocol.h"
#include "course/runner/results.h"

namespace course {

/// Thrown when the submission's process failed, after the failure has been
/// recorded. No std::exception, so that no CHECK_THROWS_AS is satisfied by it.
struct WorkerFailed {};

/// Thrown when the student's function threw a type that has no twin here.
struct StudentException : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The last call of the running case, for the message of a failed check. Texts
/// are made only when a check fails.
struct LastCall {
    std::function<std::string()> call;
    std::function<std::string()> got;
    std::vector<Visit> walk;
    std::int64_t reads = 0;
};

/// A request in the making.
struct Request {
    std::uint32_t table_count = 0;
    Writer tables;
    Writer arguments;
    const HalfEdgeTable* walked = nullptr;  ///< the first table argument
    std::uint64_t table_bytes = 0;          ///< twice the rows of all tables
};

/// One submission under judgement. There is at most one in a process: the
/// suites call plain functions.
class Client {
public:
    /// `control` is the conversation with the launcher.
    Client(Descriptor control, const Limits& limits);

    /// The client of this process, or null: the functions under test are then
    /// linked in.
    static Client* current();
    static void set_current(Client* client);

    /// A run of all cases begins: the limit of time for all of them is new.
    void begin_run();

    /// A case begins: the next call gets a fresh worker.
    void begin_case();

    /// Another limit of CPU time for all calls of this case, also where they
    /// take memory: more time than this spent in them fails the case at its
    /// end. Before its first call.
    void limit_cpu(std::chrono::milliseconds most);

    /// The table is made of copies: the worker is sent these, and makes it.
    /// Precondition: the table stays as it is, and where it is.
    void send_as(const HalfEdgeTable& table, const Copies& copies);

    /// The case is over: its worker is ended, and everything that it started.
    void end_case();

    /// Throws WorkerFailed when no more calls are made in this case, or in this
    /// run. Comes before the arguments are added.
    void begin_call();

    /// Adds a table argument: its rows once per worker, then by id.
    void add_table(Request& request, const HalfEdgeTable& table);

    /// Sends the request that `make` makes; returns the bytes of the result.
    /// Throws WorkerFailed, or what the student's function threw.
    std::string call(const std::function<Request()>& make);

    /// The next calls f(he, i) are those for some i in `starts`, in this order:
    /// with one of them some hundred are asked for, in one conversation. For as
    /// long as the function and the read budget of the calls stay the same.
    /// Where that fails, nothing has happened: a fresh worker is asked one by
    /// one, and so are all after it.
    void ask_ahead(const HalfEdgeTable& he, std::vector<int> starts);
    /// The table may be gone from then on.
    void stop_asking_ahead() {
        ahead_.reset();
        answered_.reset();
    }

    /// The reply did not decode: records it and throws WorkerFailed.
    [[noreturn]] void malformed(const std::string& why);

    LastCall& last_call() { return last_call_; }

    /// Where the last call was answered ahead: makes it once more, for its
    /// walk, which the message of a failed check shows.
    void walk_again();

    /// The case has failed, and what it asked is now tried on smaller meshes: a
    /// fresh worker, if the last one failed. False when it failed in a way that
    /// takes long, or is not allowed. Until the case ends, running out of time
    /// is quick, and has no consequence for later cases.
    bool try_again();

    /// What the submission printed in this case, at most 2 KiB, as it came.
    std::string printed() const;

    /// Where a failure of the worker goes: the suite's listener.
    std::function<void(Verdict, const std::string&)> on_failure;

private:
    struct SentTable {
        std::uint64_t id;
        const HalfEdge* rows;  ///< where the judge's table lies
        std::vector<HalfEdge> copy;
        std::uint32_t generation;        ///< the worker that has it
        const Copies* copies = nullptr;  ///< sent instead of the rows
    };

    /// The answer to a call that was not made yet.
    struct Answer {
        std::int64_t reads;
        std::string result;
    };

    /// Calls that are going to be made.
    struct Ahead {
        const HalfEdgeTable* he;
        std::vector<int> starts;
        std::size_t next = 0;    ///< the first that was not made
        std::size_t asked = 0;   ///< the first so many were asked for
        std::string table = {};  ///< the argument that they have in common
        std::vector<Answer> answers = {};  ///< of the last ones of these
    };

    void start_worker();
    void end_worker();
    std::string ask(CallStatus kind, const Request& request);
    bool is_ahead(const Request& request) const;
    std::optional<std::string> answered_ahead(const Request& request);
    const Answer* find_ahead(int start);
    void fetch_ahead(const Request& request);
    void begin_again();
    void check_time(std::chrono::milliseconds used);
    LauncherEvent wait_for_event(Event wanted, std::chrono::milliseconds most);
    SentTable& known_table(const HalfEdgeTable& table);
    Clock::time_point deadline() const;
    void send(const FrameHead& head, const Request& request,
              Clock::time_point until);
    FrameHead receive(const FrameHead& request, std::string& body,
                      Clock::time_point until);
    std::string result_of(const FrameHead& reply, const std::string& body);
    void take_trace(Reader& in);
    void note_crash(const std::string& body);
    [[noreturn]] void ran_out_of_time(const std::string& why);
    [[noreturn]] void worker_is_gone();
    [[noreturn]] void fail(Verdict verdict, const std::string& why);

    Descriptor control_;
    Limits limits_;
    std::chrono::milliseconds cpu_limit_{};  ///< of this case's worker
    Descriptor channel_;
    Descriptor output_;
    std::uint32_t generation_ = 0;
    bool alive_ = false;
    std::optional<std::pair<Verdict, std::string>>
        for_good_;  ///< no more calls
    std::optional<Crash> crash_;
    bool poisoned_ = false;   ///< the case has failed; no more calls in it
    bool is_trial_ = false;   ///< calls now come after the failure of the case
    bool not_again_ = false;  ///< some call took long, or was not allowed
    int timeouts_ = 0;
    bool loaded_ = false;  ///< some worker has loaded the submission
    Clock::time_point case_end_;
    Clock::time_point run_end_;
    std::list<SentTable> sent_;
    std::optional<Ahead> ahead_;
    std::uint64_t nonce_ = 0;    ///< of the last request
    bool is_strict_ = false;     ///< that limit is one for the whole case
    bool one_by_one_ = false;    ///< asking ahead has failed once
    bool was_endless_ = false;   ///< some worker ran out of CPU time
    bool asking_ahead_ = false;  ///< a failure now is none of the submission's
    std::optional<Request> answered_;  ///< the last call, if answered ahead
    std::uint64_t next_table_ = 1;
    LastCall last_call_;
    const HalfEdgeTable* walked_ = nullptr;
    std::uint64_t reply_extra_ = 0;  ///< what the call's input allows
};

/// Adds an argument of a call: a table as Client::add_table does, anything else
/// by value.
template <class A>
void add_argument(Client& client, Request& request, const A& argument) {
    if constexpr (std::is_same_v<A, HalfEdgeTable>)
        client.add_table(request, argument);
    else
        put(request.arguments, argument);
}

}  // namespace course
