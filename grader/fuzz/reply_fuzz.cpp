// The judge's side of a call: whatever launcher and worker answer, the call
// returns what a right answer says, or ends in WorkerFailed or in an exception
// of a student's function. An input is
//   type of the result, how the launcher behaves, status of the ended worker,
//   then replies, each a FrameHead (its nonce added to the right one, so that
//   0 is right) and its body.
#define CATCH_CONFIG_RUNNER  // the printing of values, without a main
#include "course/runner/catch2.h"

#include <cstring>
#include <thread>
#include <typeinfo>

#include "course/mesh/zoo.h"
#include "course/runner/client.h"
#include "course/runner/proxy.h"
#include "grader/fuzz/fuzz.h"
#include "grader/fuzz/types.h"

namespace {

using namespace course;

struct Reply {
    FrameHead head;
    std::string bytes;  ///< of the frame, as the worker sends them
};

/// How the launcher behaves; most numbers mean that it does its part.
/// asked_ahead: so does the launcher, and the judge asks many calls at once.
enum class Behaviour : std::uint8_t {
    asked_ahead = 252,
    not_started,
    gone,
    worker_hangs
};

struct Script {
    std::uint8_t type = 0;
    Behaviour behaviour{};
    std::int32_t status = 0;
    std::vector<Reply> replies;
};

Reply next_reply(Reader& in) {
    Reply reply{};
    const std::string_view head =
        in.take(std::min(in.left(), sizeof reply.head));
    std::memcpy(&reply.head, head.data(), head.size());
    reply.bytes = head;
    reply.bytes +=
        in.take(std::min<std::uint64_t>(in.left(), reply.head.length));
    return reply;
}

Script script_of(std::string_view bytes) {
    constexpr std::size_t most_calls = 4;
    Reader in(bytes);
    Script script;
    script.type = get<std::uint8_t>(in);
    script.behaviour = get<Behaviour>(in);
    script.status = get<std::int32_t>(in);
    while (in.left() > 0 && script.replies.size() < most_calls)
        script.replies.push_back(next_reply(in));
    return script;
}

/// Whether the frame answers the request that it is sent for.
bool is_answer(const Reply& reply) {
    return reply.bytes.size() == sizeof reply.head + reply.head.length &&
           reply.head.magic == reply_magic && reply.head.nonce == 0;
}

/// The other end of the judge's conversations: launcher and worker at once.
class Replay {
public:
    Replay(const Script& script, Descriptor control)
        : script_(script), control_(std::move(control)) {}

    void run() {
        LauncherOrder order{};
        std::vector<Descriptor> passed;
        if (script_.behaviour == Behaviour::gone ||
            !read_all(control_.get(), &order, sizeof order, &passed))
            return control_.reset();
        if (script_.behaviour == Behaviour::not_started)
            return tell(Event::not_started);
        tell(Event::started);
        play_worker(passed.at(0).get());
        passed.clear();
        tell(Event::ended);
        // Where asking ahead has failed, another worker is asked for.
        while (read_all(control_.get(), &order, sizeof order))
            if (order.order == Order::start_worker)
                tell(Event::not_started, order.generation);
    }

private:
    void tell(Event event, std::uint32_t generation = 1) const {
        const LauncherEvent message{event, generation, script_.status, 0, 0};
        write_all(control_.get(), &message, sizeof message);
    }

    /// Answers until there is nothing more to say, or the judge hangs up. Who
    /// says that it has crashed ends, or the judge waits for that.
    void play_worker(int channel) {
        for (const Reply& reply : script_.replies)
            if (!answer(channel, reply) ||
                reply.head.status == CallStatus::crashed)
                return;
        LauncherOrder end{};
        if (script_.behaviour == Behaviour::worker_hangs)
            read_all(control_.get(), &end, sizeof end);
    }

    /// Reads a request, and answers with the nonce of it.
    static bool answer(int channel, const Reply& reply) {
        FrameHead request{};
        if (!read_all(channel, &request, sizeof request)) return false;
        std::string body(request.length, '\0');
        if (!read_all(channel, body.data(), body.size())) return false;
        std::string bytes = reply.bytes;
        if (bytes.size() >= sizeof request) {
            const std::uint64_t nonce = request.nonce + reply.head.nonce;
            std::memcpy(bytes.data() + offsetof(FrameHead, nonce), &nonce,
                        sizeof nonce);
        }
        return send_all(channel, bytes,
                        Clock::now() + std::chrono::seconds(1)) ==
               Transfer::done;
    }

    const Script& script_;
    Descriptor control_;
};

bool is_of_a_student(const std::exception& error) {
    const std::type_info& type = typeid(error);
    return type == typeid(StudentException) ||
           type == typeid(std::invalid_argument) ||
           type == typeid(std::domain_error) ||
           type == typeid(std::out_of_range) ||
           type == typeid(std::length_error) ||
           type == typeid(std::logic_error) ||
           type == typeid(std::runtime_error);
}

enum class Outcome { returned, threw, failed };

template <class R>
Outcome call(const HalfEdgeTable& he, const Reply& reply) {
    try {
        const R result = remote_call<R>("f", he, 3);
        fuzz::require(
            is_answer(reply) && reply.head.status == CallStatus::returned,
            "only an answer returns");
        fuzz::require(reply.bytes.ends_with(encode(result)),
                      "what is returned is what came");
        fuzz::require(!Client::current()->last_call().got().empty(),
                      "what is returned can be shown");
        return Outcome::returned;
    } catch (const WorkerFailed&) {
        return Outcome::failed;
    } catch (const std::exception& error) {
        fuzz::require(is_of_a_student(error), "exceptions are of known types");
        fuzz::require(
            is_answer(reply) && reply.head.status == CallStatus::threw,
            "only an answer throws");
        return Outcome::threw;
    }
}

/// Once the worker has failed, the case is over, and its failure is known.
template <class R>
void play_judge(Client& client, const Script& script) {
    int failures = 0;
    client.on_failure = [&](Verdict verdict, const std::string& why) {
        ++failures;
        fuzz::require(verdict != Verdict::accepted && !why.empty(),
                      "a failure has a verdict and a reason");
    };
    const HalfEdgeTable he = zoo::slide().he;
    bool failed = false;
    for (const Reply& reply : script.replies) {
        he.begin_call(he.default_budget());
        const Outcome outcome = call<R>(he, reply);
        fuzz::require(!failed || outcome == Outcome::failed,
                      "after a failure there are no more answers");
        failed = outcome == Outcome::failed;
        fuzz::require(failures == (failed ? 1 : 0), "a failure is told once");
        fuzz::require(he.reads() >= 0 && he.last_visits().size() <= 64,
                      "what was read makes sense");
    }
}

/// One request for several calls, of which the judge then makes one.
template <class R>
void play_ahead(Client& client, const Script& script) {
    client.on_failure = [](Verdict, const std::string&) {};
    const HalfEdgeTable he = zoo::slide().he;
    he.begin_call(he.default_budget());
    client.ask_ahead(he, {3, 5});
    try {
        remote_call<R>("f", he, 3);
        const Reply& reply = script.replies.front();
        fuzz::require(
            is_answer(reply) && reply.head.status == CallStatus::returned,
            "only an answer returns");
    } catch (const WorkerFailed&) {
    } catch (const std::exception& error) {
        fuzz::require(is_of_a_student(error), "exceptions are of known types");
    }
    fuzz::require(he.reads() >= 0, "what was read makes sense");
}

Limits short_limits() {
    Limits limits;
    limits.call_ms = limits.later_call_ms = 4;
    limits.case_ms = 10'000;  // a machine under load is no hanging worker
    return limits;
}

void play(const Script& script) {
    DescriptorPair control = socket_pair();
    std::optional<Client> client;
    client.emplace(std::move(control.first),
                   script.behaviour == Behaviour::worker_hangs ? short_limits()
                                                               : Limits());
    Client::set_current(&*client);
    Replay replay(script, std::move(control.second));
    const std::jthread other_end([&] { replay.run(); });
    client->begin_case();
    fuzz::with_type(std::type_identity<fuzz::ResultTypes>(), script.type,
                    [&]<class R>(std::type_identity<R>) {
                        if (script.behaviour == Behaviour::asked_ahead)
                            play_ahead<R>(*client, script);
                        else
                            play_judge<R>(*client, script);
                    });
    fuzz::require(client->printed().empty(), "the worker printed nothing");
    client->end_case();
    client.reset();  // the other end then ends, too
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const Script script = script_of(fuzz::text_of(data, size));
        if (!script.replies.empty()) play(script);
    } catch (const CodecError&) {
        return -1;  // no script
    }
    return 0;
}
