#include "course/cli/rechecker.h"

#include <fmt/format.h>

#include <algorithm>

#include "course/cli/check.h"
#include "course/runner/make_ready.h"

namespace course {

namespace {

// Editors that format a file write it several times.
constexpr std::chrono::milliseconds settling{20};

int build_suite(const Exercise& exercise) {
    make_ready({exercise}, {JudgeKind::lab});
    return 0;
}

int check_and_tell(const Desk& desk, const Exercise& exercise) {
    const ExerciseResult result = check_mine(desk, exercise);
    fmt::print("{}", explain_mine(desk, exercise, result));
    return exit_code(result.verdict);
}

}  // namespace

Rechecker::Rechecker(const Desk& desk, const Exercise& exercise)
    : desk_(desk), exercise_(exercise), watch_(desk.file(exercise)) {
    begin();
}

void Rechecker::begin() {
    due_.reset();
    if (is_building()) return;
    run_.reset();
    run_.emplace([this] {
        return is_ready_ ? check_and_tell(desk_, exercise_)
                         : build_suite(exercise_);
    });
}

std::vector<pollfd> Rechecker::waits_for() const {
    std::vector<pollfd> list;
    if (watch_.descriptor() >= 0)
        list.push_back({watch_.descriptor(), POLLIN, 0});
    if (run_) list.push_back({run_->descriptor(), POLLIN, 0});
    return list;
}

std::chrono::milliseconds Rechecker::patience() const {
    if (!due_) return watch_.patience();
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(*due_ - Clock::now());
    return std::clamp(left, std::chrono::milliseconds(0), watch_.patience());
}

bool Rechecker::step() {
    if (watch_.has_changed()) due_ = Clock::now() + settling;
    if (due_ && Clock::now() >= *due_) begin();
    if (!run_ || !run_->has_ended()) return false;
    if (is_building() && run_->code() == 0) {
        is_ready_ = true;
        begin();
        return false;
    }
    outcome_ = {run_->output(), run_->code()};
    run_.reset();
    return !due_;
}

std::vector<int> wait_for(std::vector<pollfd> list,
                          std::chrono::milliseconds most) {
    ::poll(list.data(), static_cast<nfds_t>(list.size()),
           static_cast<int>(most.count()));
    std::vector<int> ready;
    for (const pollfd& one : list)
        if (one.revents != 0) ready.push_back(one.fd);
    return ready;
}

}  // namespace course
