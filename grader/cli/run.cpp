// grader run DIR --out OUT
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

#include "grader/cli/commands.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/assignment.h"
#include "grader/pipeline/grade_class.h"
#include "grader/pipeline/ingest.h"
#include "grader/report/class_results.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

struct Options {
    fs::path dir;
    fs::path out;
    fs::path assignment;
    std::string only;
    JudgingOptions judging;
};

std::atomic<bool> interrupted = false;

void on_interrupt(int) {
    interrupted = true;
}

/// One line at the terminal that is written over again and again.
class ProgressLine {
public:
    void show(const Progress& progress) const {
        if (!on_terminal_) return;
        const double seconds =
            std::chrono::duration<double>(course::Clock::now() - start_)
                .count();
        const double left =
            seconds / progress.done * (progress.all - progress.done);
        fmt::print(stderr, "\r{} of {} judged{}, about {:.0f} s left \033[K",
                   progress.done, progress.all,
                   progress.faults > 0
                       ? fmt::format(", {} grader faults", progress.faults)
                       : "",
                   left);
    }
    ~ProgressLine() {
        if (on_terminal_) fmt::print(stderr, "\r\033[K");
    }

private:
    bool on_terminal_ = ::isatty(STDERR_FILENO) == 1;
    course::Clock::time_point start_ = course::Clock::now();
};

std::vector<std::string> names_of(
    const std::vector<course::Exercise>& exercises) {
    std::vector<std::string> names;
    for (const course::Exercise& exercise : exercises)
        names.push_back(exercise.full_name());
    return names;
}

Assignment assignment_of(const Options& options,
                         const std::vector<std::string>& names) {
    if (options.assignment.empty()) return default_assignment(names);
    try {
        return read_assignment(options.assignment, names);
    } catch (const AssignmentError& error) {
        throw CannotBegin(error.what());
    }
}

SubmittedClass submissions_of(const Options& options,
                              const std::vector<course::Exercise>& exercises) {
    std::vector<std::string> files;
    for (const course::Exercise& exercise : exercises)
        files.push_back(exercise.file_name());
    try {
        SubmittedClass found = find_submissions(options.dir, files);
        const auto is_meant = [&](const Submission& s) {
            return s.id == options.only || s.student == options.only;
        };
        if (!options.only.empty() &&
            std::none_of(found.submissions.begin(), found.submissions.end(),
                         is_meant))
            throw CannotBegin(
                fmt::format("{} has no folder or archive of \"{}\"",
                            options.dir.string(), options.only));
        return found;
    } catch (const IngestError& error) {
        throw CannotBegin(error.what());
    }
}

void print_summary(const ClassRunResult& done, const Options& options) {
    if (done.unchanged > 0)
        fmt::print("{} submissions were unchanged and not graded again.\n",
                   done.unchanged);
    fmt::print("{} submissions were graded.\n", done.judged);
    if (done.faults > 0)
        fmt::print(
            "{} ended in a grader fault, which is no grade: run the "
            "command again to retry them.\n",
            done.faults);
    fmt::print("\nReport:     {}\nGrades:     {}\nPer student: {}\n",
               (options.out / "report.html").string(),
               (options.out / "grades.csv").string(),
               (options.out / "students").string());
}

bool has_fault(const ClassResults& results) {
    return std::any_of(results.students.begin(), results.students.end(),
                       [](const StudentResults& student) {
                           return status(student) == Status::grader_fault;
                       });
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

int run_command(const Options& options) {
    const auto all = course::all_exercises();
    const Assignment assignment = assignment_of(options, names_of(all));
    ClassRun run;
    for (const Assignment::Item& item : assignment.exercises)
        run.exercises.push_back(
            course::exercise_named(std::string(short_name(item.exercise))));
    run.submitted = submissions_of(options, run.exercises);
    const Bench bench(options.judging);
    run.only = options.only;
    run.judging = {options.judging.seed, options.judging.repeats};
    run.jobs = bench.jobs();
    run.isolation = bench.isolation_text();
    fmt::print(stderr, "Isolation: {}\n", run.isolation);
    fs::create_directories(options.out);
    const course::Descriptor lock = lock_folder(options.out);
    Gradebook gradebook(options.out / "gradebook.sqlite");
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    ClassRunResult done;
    LocalExecutor executor(run.jobs, run.judging,
                           [&](int lane) { return bench.workplace(lane); });
    {
        const ProgressLine line;
        done = grade_class(
            run, gradebook, executor,
            [&](const Progress& progress) { line.show(progress); },
            []() -> bool { return interrupted; });
    }
    const ClassResults results = class_results(gradebook, assignment);
    write_reports(results, options.out);
    fmt::print("{}\n", class_table(results, colour_of(STDOUT_FILENO)));
    print_summary(done, options);
    if (done.stopped) {
        fmt::print(
            "Stopped before the end: run the same command again to go "
            "on.\n");
        return 1;
    }
    return has_fault(results) ? 1 : 0;
}

}  // namespace

void add_run(CLI::App& program, int& code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "run",
        "Grade a class: a folder or an archive with a folder or an archive "
        "for each student");
    command
        ->add_option("dir", options->dir,
                     "the folder of the class, or an archive of it (.zip, "
                     ".tar, .tar.gz, .tgz, .tar.bz2, .tar.xz, .tar.zst)")
        ->required();
    command
        ->add_option("--out", options->out,
                     "folder for gradebook, grades and reports")
        ->required();
    command->add_option("--assignment", options->assignment,
                        "which exercises, with which weights (default: all)");
    command->add_option(
        "--only", options->only,
        "judge only this student (name of the folder or archive, "
        "or id)");
    options->judging.add_to(*command);
    command->footer(
        "What is recorded in OUT is never graded again; a run that was cut "
        "short goes on.\nExit code: 0 every submission got its grade, 1 one "
        "ended in a grader fault or the\nrun was stopped, 2 wrong usage, 3 the "
        "grader itself failed.");
    command->callback([options, &code] { code = run_command(*options); });
}

}  // namespace grader
