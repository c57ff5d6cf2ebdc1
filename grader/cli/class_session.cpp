#include "grader/cli/class_session.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "course/runner/make_ready.h"
#include "grader/pipeline/ingest.h"
#include "grader/pipeline/mistakes.h"
#include "grader/pipeline/submission_times.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

std::atomic<bool> interrupted = false;

void on_interrupt(int signal) {
    constexpr std::string_view words =
        "\nStopping: what is being judged is finished first. Once more ends it "
        "at once.\n";
    interrupted = true;
    std::signal(signal, SIG_DFL);
    [[maybe_unused]] const ssize_t n =
        ::write(STDERR_FILENO, words.data(), words.size());
}

std::string in_words(double left) {
    if (left < 90) return fmt::format("{:.0f} s", left);
    if (left < 5400) return fmt::format("{:.0f} min", left / 60);
    return fmt::format("{:.1f} h", left / 3600);
}

/// How far a run is: at a terminal one line that is written over again and
/// again, elsewhere a line each half minute.
class ProgressLine {
public:
    void show(const Progress& progress) {
        const course::Clock::time_point now = course::Clock::now();
        if (!on_terminal_ && now < next_) return;
        next_ = now + seconds(30);
        fmt::print(stderr, "{}{}{}", on_terminal_ ? "\r" : "", text(progress),
                   on_terminal_ ? " \033[K" : "\n");
        std::fflush(stderr);
    }
    ~ProgressLine() {
        if (on_terminal_) fmt::print(stderr, "\r\033[K");
    }

private:
    std::string text(const Progress& progress) const {
        std::string line =
            fmt::format("{} of {} judged", progress.done, progress.all);
        if (progress.failed > 0)
            line += fmt::format(", {} failed", progress.failed);
        if (progress.faults > 0)
            line += fmt::format(", {} grader faults", progress.faults);
        if (progress.done == 0) return line;
        const double spent =
            std::chrono::duration<double>(course::Clock::now() - start_)
                .count();
        const int left = progress.all - progress.done;
        return line + fmt::format(", about {} left",
                                  in_words(spent / progress.done * left));
    }

    bool on_terminal_ = ::isatty(STDERR_FILENO) == 1;
    course::Clock::time_point start_ = course::Clock::now();
    course::Clock::time_point next_ = start_ + seconds(30);
};

std::vector<std::string> names_of(
    const std::vector<course::Exercise>& exercises) {
    std::vector<std::string> names;
    for (const course::Exercise& exercise : exercises)
        names.push_back(exercise.full_name());
    return names;
}

/// By what --platform calls them.
const std::map<std::string, Platform> platforms = {
    {"plain", Platform::plain},           {"moodle", Platform::moodle},
    {"canvas", Platform::canvas},         {"github", Platform::github},
    {"gradescope", Platform::gradescope},
};

std::optional<Platform> platform_of(const ClassOptions& options) {
    if (options.platform.empty()) return std::nullopt;
    return platforms.at(options.platform);
}

void add_times(const ClassOptions& options,
               const std::optional<Assignment>& assignment,
               SubmittedClass& submitted) {
    const bool has_due = assignment && assignment->due;
    const std::string zone = has_due ? assignment->due->zone : "UTC";
    try {
        if (options.times == "files")
            take_times_of_files(submitted, zone);
        else if (!options.times.empty())
            take_times_from(CsvTable(course::read_file(options.times)), zone,
                            assignment && assignment->in_teams, submitted);
    } catch (const std::runtime_error& error) {
        throw CannotBegin(fmt::format("{}: {}", options.times, error.what()));
    }
    if (has_due) note_missing_times(submitted);
}

/// Two graders in one folder would grade everything twice. Given back by the
/// system, also when this process is killed.
course::Descriptor lock_folder(const fs::path& folder) {
    course::Descriptor lock(
        ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!lock) course::throw_errno("cannot open " + folder.string());
    // Where a file system has no locks, the gradebook's own still hold.
    if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw CannotBegin(fmt::format(
            "{}: another grader is at work there; wait for its end, or choose "
            "another folder",
            folder.string()));
    return lock;
}

/// The chapters of which somebody handed in a file; all when nobody did.
std::set<std::string> chapters_handed_in(const ClassRun& run) {
    std::set<std::string> chapters;
    for (const Submission& submission : run.submitted.submissions)
        for (std::size_t k = 0; k < run.exercises.size(); ++k)
            if (submission.files[k]) chapters.insert(run.exercises[k].topic);
    if (chapters.empty())
        for (const course::Exercise& exercise : run.exercises)
            chapters.insert(exercise.topic);
    return chapters;
}

/// Leaves out what is not of these chapters.
void keep_chapters(ClassRun& run, const std::set<std::string>& chapters) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < run.exercises.size(); ++k) {
        if (!chapters.contains(run.exercises[k].topic)) continue;
        for (Submission& submission : run.submitted.submissions)
            submission.files[kept] = submission.files[k];
        run.exercises[kept++] = run.exercises[k];
    }
    run.exercises.resize(kept);
    for (Submission& submission : run.submitted.submissions)
        submission.files.resize(kept);
}

ClassRun class_run(const ClassOptions& options,
                   const std::optional<Assignment>& assignment) {
    ClassRun run;
    run.exercises = exercises_of(assignment);
    run.submitted = submissions_of(options, run.exercises);
    add_times(options, assignment, run.submitted);
    if (!assignment) keep_chapters(run, chapters_handed_in(run));
    course::make_ready(run.exercises, {course::JudgeKind::grade});
    run.only = options.only;
    run.judging = {options.judging.seed, options.judging.repeats};
    return run;
}

course::Descriptor make_and_lock(const fs::path& folder) {
    fs::create_directories(folder);
    return lock_folder(folder);
}

}  // namespace

SubmittedClass submissions_of(const ClassOptions& options,
                              const std::vector<course::Exercise>& exercises) {
    std::vector<std::string> files;
    for (const course::Exercise& exercise : exercises)
        files.push_back(exercise.file_name());
    try {
        SubmittedClass found =
            find_submissions(options.dir, files, {}, platform_of(options));
        if (!options.only.empty() &&
            std::none_of(
                found.submissions.begin(), found.submissions.end(),
                [&](const Submission& s) { return is_named(s, options.only); }))
            throw CannotBegin(
                fmt::format("{} has no folder or archive of \"{}\"",
                            options.dir.string(), options.only));
        return found;
    } catch (const IngestError& error) {
        throw CannotBegin(error.what());
    }
}

std::optional<Assignment> assignment_in(const fs::path& file) {
    if (file.empty()) return std::nullopt;
    try {
        return read_assignment(file, names_of(course::all_exercises()));
    } catch (const AssignmentError& error) {
        throw CannotBegin(error.what());
    }
}

void ClassOptions::add_to(CLI::App& app) {
    app.add_option("dir", dir,
                   "the folder of the class, or an archive of it (.zip, "
                   ".tar, .tar.gz, .tgz, .tar.bz2, .tar.xz, .tar.zst)")
        ->required();
    app.add_option("--out", out, "folder for gradebook, grades and reports")
        ->required();
    app.add_option("--assignment", assignment,
                   "which exercises, with which weights (default: those of "
                   "the chapters of which somebody handed in a file)");
    app.add_option("--only", only,
                   "judge only this student (name of the folder or archive, "
                   "id, or name or number on the platform)");
    app.add_option("--platform", platform,
                   "whose export this is (default: told by its names): "
                   "moodle, canvas, gradescope, github or plain")
        ->check(CLI::IsMember(platforms));
    app.add_option("--times", times,
                   "when each student handed in, where the export does not say "
                   "it: \"files\" (the newest file), or a CSV file of names or "
                   "numbers and times, or Moodle's grading worksheet");
    app.add_flag("--no-mistakes", no_mistakes,
                 "do not judge stored wrong submissions to recognise their "
                 "mistakes");
    judging.add_to(app);
    executor.add_to(app);
}

ClassSession::ClassSession(const ClassOptions& options)
    : chosen_(assignment_in(options.assignment)),
      run_(class_run(options, chosen_)),
      assignment_(chosen_ ? *chosen_
                          : default_assignment(names_of(run_.exercises))),
      bench_(options.judging),
      lock_(make_and_lock(options.out)),
      gradebook_(options.out / "gradebook.sqlite"),
      executor_(
          executor_for(options.executor, bench_, run_.judging, options.out)),
      no_mistakes_(options.no_mistakes) {
    run_.jobs = bench_.jobs();
    run_.isolation = bench_.isolation_text();
    fmt::print(stderr, "Isolation: {}\n", run_.isolation);
}

ClassRunResult ClassSession::grade(bool propose) {
    run_.propose = propose;
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    const auto is_stopped = []() -> bool { return interrupted; };
    const ClassRunResult done = grade_judging(is_stopped);
    if (!no_mistakes_ && !done.stopped)
        learn_mistakes(
            run_, done.run, gradebook_, *executor_,
            [](const std::string& text) { fmt::print(stderr, "{}\n", text); },
            is_stopped);
    return done;
}

ClassRunResult ClassSession::grade_judging(const std::function<bool()>& stop) {
    ProgressLine line;
    return grade_class(
        run_, gradebook_, *executor_,
        [&](const Progress& progress) { line.show(progress); }, stop);
}

}  // namespace grader
