#include "grader/pipeline/slurm_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "grader/pipeline/keys.h"

namespace grader {

namespace {

using course::Clock;
using course::ExerciseResult;
using course::Verdict;
using Kind = QueueState::Kind;
using std::chrono::milliseconds;

/// How often stop() is asked, how often the folder is listed (less often where
/// that takes long), how often the queue is asked, which sites count.
constexpr milliseconds tick{100}, look_every{500}, ask_every{5000};

/// What the end of a job may take until its folder is removed.
constexpr milliseconds most_for_end{5000};

/// A task takes a fraction of a second as a rule: 200 of them are about a
/// minute of one core, and fewer than 20 not worth a start. In between, the
/// more cores the better. What a round leaves undone may have ended its chunk:
/// smaller ones take less along.
std::size_t chunk_size(std::size_t tasks, std::size_t wanted, int round,
                       std::size_t most_chunks) {
    constexpr std::size_t few = 20, many = 200, side_by_side = 64;
    std::size_t size = wanted;
    if (size == 0) size = std::clamp(tasks / side_by_side, few, many);
    for (int k = 1; k < round; ++k) size = std::max<std::size_t>(size / 4, 1);
    return std::max(size, (tasks + most_chunks - 1) / most_chunks);
}

}  // namespace

SlurmRound::SlurmRound(const SlurmWork& work, std::vector<Pending> tasks,
                       int number)
    : work_(work),
      tasks_(std::move(tasks)),
      number_(number),
      folder_(JobFolder::make(work.folder)),
      seen_(tasks_.size(), false),
      left_(tasks_.size()) {}

void SlurmRound::say(const std::string& text) {
    if (text != said_) work_.options.say(folder_.name() + ": " + text);
    said_ = text;
}

void SlurmRound::write_tasks(std::size_t most_chunks) {
    job_.conditions = work_.conditions;
    job_.chunk =
        chunk_size(tasks_.size(), work_.options.chunk, number_, most_chunks);
    for (std::size_t k = 0; k < tasks_.size() && !work_.stop(); ++k) {
        const Task task = work_.tasks.at(tasks_[k].task);
        folder_.write_source(k, task.source);
        job_.tasks.push_back({task.exercise->full_name(), sha256(task.source)});
        job_.limits[task.exercise->full_name()] = task.exercise->limits;
    }
    job_.build = build_version(exercises_of(job_));
    folder_.write(job_);
}

void SlurmRound::submit() {
    try {
        write_tasks(work_.queue.most_chunks());
        if (work_.stop()) return;
        say(fmt::format("{} tasks in {} chunks{}", tasks_.size(), job_.chunks(),
                        number_ == 1 ? "" : ", which had no result before"));
        work_.queue.submit(folder_.path(), job_.chunks());
    } catch (...) {
        folder_.remove();
        throw;
    }
}

/// Takes what has come. A file that is no result yet may become one; a fault
/// of the grader gets another chance, on another node.
void SlurmRound::look() {
    for (const std::size_t k : folder_.results()) {
        if (k >= job_.tasks.size() || seen_[k]) continue;
        const auto result = folder_.result(k, job_.tasks[k]);
        if (!result) continue;
        if (result->verdict == Verdict::grader_fault && !tasks_[k].was_fault &&
            number_ < slurm_rounds)
            again_.push_back({tasks_[k].task, true});
        else
            work_.take(tasks_[k].task, *result);
        seen_[k] = true;
        --left_;
    }
}

void SlurmRound::ask() {
    const QueueState state = work_.queue.state(folder_.name());
    if (state.kind == Kind::gone)
        ended_ = Clock::now();
    else if (state.kind == Kind::waiting)
        say("waits in the queue: " + state.reason);
    else if (state.kind == Kind::running)
        say("runs");
    else
        say("the queue does not answer");
}

/// Until all is there, or the job has ended without it, or stop().
void SlurmRound::watch() {
    auto next_look = Clock::now(), next_question = next_look;
    for (;; std::this_thread::sleep_for(tick)) {
        const auto now = Clock::now();
        const bool late = ended_ && now > *ended_ + work_.options.grace;
        if (late || now >= next_look) {
            look();
            const auto took = Clock::now() - now;
            next_look = now + std::max<Clock::duration>(look_every, 10 * took);
        }
        if (late || left_ == 0 || work_.stop()) return;
        if (!ended_ && now >= next_question) {
            ask();
            next_question = now + ask_every;
        }
    }
}

/// Its chunks have files open in the folder.
void SlurmRound::wait_for_end() {
    const auto until = Clock::now() + most_for_end;
    while (!ended_ && Clock::now() < until) {
        if (work_.queue.state(folder_.name()).kind == Kind::gone)
            ended_ = Clock::now();
        else
            std::this_thread::sleep_for(look_every);
    }
}

void SlurmRound::give_up() {
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
        if (seen_[k]) continue;
        ExerciseResult fault;
        fault.message =
            fmt::format("the cluster gave no result: {}",
                        folder_.log(k / static_cast<std::size_t>(job_.chunk)));
        work_.take(tasks_[k].task, fault);
    }
    say("gave no result for all tasks; its logs stay in " +
        folder_.path().string());
}

/// Nothing of the job runs after this.
void SlurmRound::finish() {
    if (left_ > 0) {
        work_.queue.cancel(folder_.name());
        look();
    }
    wait_for_end();
    if (left_ > 0 && number_ == slurm_rounds && !work_.stop()) return give_up();
    for (std::size_t k = 0; k < tasks_.size(); ++k)
        if (!seen_[k]) again_.push_back(tasks_[k]);
    folder_.remove();
}

std::vector<Pending> SlurmRound::go() {
    submit();
    try {
        if (!work_.stop()) watch();
        finish();
    } catch (...) {
        work_.queue.cancel(folder_.name());
        throw;
    }
    return std::move(again_);
}

}  // namespace grader
