#include "course/player/reference.h"

#include <fmt/format.h>

#include "course/runner/judge_submission.h"
#include "course/runner/make_ready.h"

namespace course {

namespace {

/// It is ours, and makes meshes that no case of a suite asks for: more time
/// than a submission has.
Limits limits_of_reference() {
    constexpr std::int32_t minute_ms = 60'000;
    Limits limits;
    limits.call_ms = limits.case_ms = limits.run_ms = minute_ms;
    limits.cpu_ms = minute_ms;
    limits.cpu_seconds = 60;
    limits.reply_kib = 16 * 1024;
    return limits;
}

}  // namespace

ReferenceWorker::ReferenceWorker(const std::string& exercise)
    : name_(exercise), complaints_(anonymous_file()) {
    const Exercise found = exercise_named(exercise);
    make_ready({found}, {});
    LocalWorkplace workplace;
    const std::filesystem::path shared = folder_ / "reference.so";
    const Compiled compiled =
        workplace.compile(found, found.solution(), shared);
    if (compiled.verdict != Verdict::accepted)
        throw SystemError(fmt::format("{} does not compile:\n{}",
                                      found.solution().string(),
                                      compiled.messages));
    DescriptorPair control = socket_pair();
    launcher_ = std::make_unique<Process>(workplace.launch(
        shared, limits_of_reference(), control.second, complaints_));
    client_ = std::make_unique<Client>(std::move(control.first),
                                       limits_of_reference());
    client_->on_failure = [this](Verdict, const std::string& why) {
        failure_ = why;
    };
    client_->begin_case();
}

ReferenceWorker::~ReferenceWorker() {
    client_.reset();  // the launcher ends when nobody speaks to it
    launcher_->end_within(std::chrono::seconds(2));
}

std::string ReferenceWorker::call(
    const std::function<void(Client&, Request&)>& add) {
    try {
        client_->begin_call();
        return client_->call([&] {
            Request request;
            add(*client_, request);
            return request;
        });
    } catch (const WorkerFailed&) {
        throw SystemError(fmt::format("the reference of {} failed: {}\n{}",
                                      name_, failure_,
                                      last_bytes(complaints_.get())));
    }
}

}  // namespace course
