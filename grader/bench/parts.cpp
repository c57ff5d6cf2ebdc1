#include "grader/bench/parts.h"

#include <fmt/format.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <future>

#include "course/runner/compile.h"
#include "course/runner/run_judge.h"
#include "course/runner/temporary_folder.h"
#include "grader/bench/made_class.h"
#include "grader/bench/ways.h"

namespace grader::bench {

namespace {

namespace fs = std::filesystem;
using course::TemporaryFolder;

int or_else(int asked, int chosen) {
    return asked > 0 ? asked : chosen;
}

/// The mean over all files of what `way` takes.
double mean_of(const std::vector<HandedIn>& files,
               const std::function<double(const HandedIn&)>& way) {
    double sum = 0;
    for (const HandedIn& handed : files) sum += way(handed);
    return sum / static_cast<double>(files.size());
}

/// One submission in the middle of a class: the grader on one student and on
/// two, so that what it does once for a class falls out.
class OneSubmission {
public:
    explicit OneSubmission(int exercises)
        : one_(made("one", 1, exercises)), two_(made("two", 2, exercises)) {}

    const std::vector<HandedIn>& files() const { return one_.files; }

    void measure_once() {
        const double one = graded(one_);
        const double more = graded(two_) - one;
        seconds.push_back(more / static_cast<double>(one_.files.size()));
        start_up.push_back(one - more);
    }

    Samples seconds;
    Samples start_up;

private:
    MadeClass made(const std::string& name, int students, int exercises) {
        fs::create_directory(folder_ / name);
        return make_class(folder_ / name,
                          {students, chosen_exercises(exercises)});
    }
    static double graded(const MadeClass& made) {
        const TemporaryFolder out;
        return grade(made, out / "out", 1).seconds;
    }

    TemporaryFolder folder_;
    MadeClass one_, two_;
};

/// Only compiling: files first to last with as many jobs.
double compile_some(const std::vector<HandedIn>& files, std::size_t first,
                    std::size_t last, int jobs) {
    const TemporaryFolder scratch;
    std::atomic<std::size_t> next = first;
    const auto compile_until_none = [&](const fs::path& folder) {
        fs::create_directory(folder);
        for (std::size_t k = next++; k < last; k = next++)
            compile_alone(files[k], folder);
    };
    const auto start = course::Clock::now();
    std::vector<std::future<void>> lanes;
    for (int lane = 0; lane < jobs; ++lane)
        lanes.push_back(std::async(std::launch::async, compile_until_none,
                                   scratch / std::to_string(lane)));
    for (std::future<void>& lane : lanes) lane.get();
    return std::chrono::duration<double>(course::Clock::now() - start).count();
}

/// The least that bubblewrap does, by hand: all namespaces, the machine as it
/// is. The grader's own sandbox shows less and asks for more.
Arguments in_bubblewrap(const fs::path& scratch, const Arguments& command) {
    Arguments list = {"bwrap",
                      "--unshare-all",
                      "--die-with-parent",
                      "--ro-bind",
                      "/",
                      "/",
                      "--dev",
                      "/dev",
                      "--bind",
                      scratch,
                      scratch,
                      "--"};
    list.insert(list.end(), command.begin(), command.end());
    return list;
}

Arguments compile_command(const HandedIn& handed, const fs::path& scratch) {
    return course::compile_arguments(
        handed.file, scratch / "s.o", course::student_include(),
        course::prelude_for(course::read_file(handed.file)));
}

/// What a submission consists of, each step alone.
class Steps {
public:
    void measure_once(const std::vector<HandedIn>& files) {
        const auto mean = [&](const auto& command) {
            return mean_of(files, [&](const HandedIn& handed) {
                return seconds_of(command(handed));
            });
        };
        alone.push_back(mean([&](const HandedIn& handed) {
            return compile_command(handed, scratch_.path());
        }));
        inside.push_back(mean([&](const HandedIn& handed) {
            return in_bubblewrap(scratch_.path(),
                                 compile_command(handed, scratch_.path()));
        }));
        link.push_back(mean([&](const HandedIn& handed) {
            return course::link_arguments(
                {scratch_ / "s.o", course::entry_object(handed.exercise)},
                scratch_ / "s.so");
        }));
        start.push_back(mean([&](const HandedIn&) {
            return in_bubblewrap(scratch_.path(), {"true"});
        }));
        judge.push_back(mean([](const HandedIn& handed) {
            return Arguments{course::judge_program(
                handed.exercise, course::JudgeKind::reference)};
        }));
    }

    Samples alone, inside, link, start, judge;

private:
    TemporaryFolder scratch_;
};

/// What each round of `submission` measures, one sample for each round.
struct Usual {
    Samples floor, command, project;
};

void report_submission(const OneSubmission& one, const Usual& usual,
                       Report& report) {
    report.add({"a: g++ -std=c++20 -O0 -c", usual.floor, "s"});
    report.add({"b: this grader, all included", one.seconds, "s"});
    report.add({"b: its start-up, once for a class", one.start_up, "s"});
    report.add({"c: one g++ command with Catch2", usual.command, "s"});
    report.add({"d: a CMake project", usual.project, "s"});
    report.add({"b / a", ratios(one.seconds, usual.floor), "", 0.7});
    report.add({"b / c", ratios(one.seconds, usual.command), "", 1.0 / 80});
    report.add({"b / d", ratios(one.seconds, usual.project), "", 1.0 / 20});
    report.note(
        "All four are means over the same files, one after the other, each "
        "with "
        "one job. a, c and d have no sandbox.");
}

void report_class(double floor, const Measured& first, const Measured& again,
                  std::size_t files, Report& report) {
    report.add({"g++ -std=c++20 -O0 -c of each", {floor}, "s"});
    report.add({"this grader", {first.seconds}, "s"});
    report.add({"grader / g++", {first.seconds / floor}, "", 0.8});
    report.add({"peak memory of the grader", {first.peak_mib}, "MiB"});
    const double hundreds = static_cast<double>(files) / 100;
    report.add({"second run, for a hundred submissions",
                {again.seconds / hundreds},
                "s",
                1.0});
    report.add({"peak memory of the second run", {again.peak_mib}, "MiB"});
}

void report_shares(const OneSubmission& one, const Steps& steps,
                   Report& report) {
    report.add({"this grader, a submission", one.seconds, "s"});
    report.add({"its compile command", steps.alone, "s"});
    report.add({"its compile command in bubblewrap", steps.inside, "s"});
    report.add({"ld", steps.link, "s"});
    report.add({"bubblewrap around `true`", steps.start, "s"});
    report.add({"judge, reference linked in, cases once", steps.judge, "s"});
    Samples rest;
    for (std::size_t k = 0; k < one.seconds.size(); ++k)
        rest.push_back(one.seconds[k] - steps.inside[k] - steps.link[k] -
                       steps.start[k] - 2 * steps.judge[k]);
    report.add({"rest: workers, conversation, gradebook", rest, "s"});
    report.note(
        "Rest: the submission without compiling in bubblewrap, ld, one more "
        "sandbox, the judge twice. Cases tagged [once] are run once, so it is "
        "more.");
}

void measure_sizes(const Settings& settings, Report& report) {
    std::vector<int> sizes = {30, 300, 3000};
    if (settings.quick) sizes = {10, 30, 100};
    for (const int students : sizes) {
        const TemporaryFolder folder;
        const MadeClass made =
            make_class(folder.path(), {students, chosen_exercises(1)});
        const Measured run = grade(made, folder / "out", settings.jobs);
        const std::string who = fmt::format("{} students: ", students);
        report.add({who + "a submission", {run.seconds / students}, "s"});
        report.add({who + "peak memory", {run.peak_mib}, "MiB"});
    }
}

void measure_lanes(const Settings& settings, Report& report) {
    const int students = settings.quick ? 12 : 40;
    const int rounds = settings.quick ? 1 : 3;
    const std::vector<int> lanes = {1, 2, 4};
    const TemporaryFolder folder;
    const MadeClass made =
        make_class(folder.path(), {students, chosen_exercises(1)});
    std::vector<Samples> seconds(lanes.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < lanes.size(); ++k) {
            const TemporaryFolder out;
            seconds[k].push_back(grade(made, out / "out", lanes[k]).seconds /
                                 students);
        }
    for (std::size_t k = 0; k < lanes.size(); ++k)
        report.add({fmt::format("{} students, --jobs {}: a submission",
                                students, lanes[k]),
                    seconds[k], "s"});
}

}  // namespace

void submission(const Settings& settings, Report& report) {
    OneSubmission one(or_else(settings.exercises, settings.quick ? 3 : 15));
    const auto& files = one.files();
    report.begin_part("submission",
                      fmt::format("{} references, one lane", files.size()));
    const std::size_t rounds = settings.quick ? 3 : 5;
    const std::size_t slow_rounds = settings.quick ? 1 : 3;
    const TemporaryFolder scratch;
    Usual usual;
    for (std::size_t round = 0; round < rounds; ++round) {
        usual.floor.push_back(mean_of(files, [&](const HandedIn& handed) {
            return compile_alone(handed, scratch.path());
        }));
        one.measure_once();
        if (round >= slow_rounds) continue;
        usual.command.push_back(mean_of(files, [&](const HandedIn& handed) {
            return one_command(handed, scratch.path());
        }));
        usual.project.push_back(mean_of(files, [&](const HandedIn& handed) {
            return cmake_project(handed, scratch.path());
        }));
    }
    report_submission(one, usual, report);
}

void whole_class(const Settings& settings, Report& report) {
    const int students = or_else(settings.students, settings.quick ? 10 : 60);
    const int exercises = or_else(settings.exercises, settings.quick ? 4 : 10);
    const TemporaryFolder folder;
    const MadeClass made = make_class(
        folder.path(), {students, chosen_exercises(exercises), Content::mixed});
    const std::size_t n = made.files.size();
    report.begin_part("class",
                      fmt::format("{} files of {} students, one in twenty "
                                  "endless, {} jobs",
                                  n, students, settings.jobs));
    // One half before and one after: a machine that gets slower does it to all.
    double floor = compile_some(made.files, 0, n / 2, settings.jobs);
    const Measured first = grade(made, folder / "out", settings.jobs);
    floor += compile_some(made.files, n / 2, n, settings.jobs);
    const Measured again = grade(made, folder / "out", settings.jobs);
    report_class(floor, first, again, n, report);
}

void shares(const Settings& settings, Report& report) {
    OneSubmission one(or_else(settings.exercises, settings.quick ? 3 : 15));
    report.begin_part(
        "shares", fmt::format("{} references, one lane", one.files().size()));
    Steps steps;
    const int rounds = settings.quick ? 2 : 5;
    for (int round = 0; round < rounds; ++round) {
        one.measure_once();
        steps.measure_once(one.files());
    }
    report_shares(one, steps, report);
}

void scaling(const Settings& settings, Report& report) {
    report.begin_part("scaling",
                      fmt::format("one exercise, {} jobs", settings.jobs));
    measure_sizes(settings, report);
    measure_lanes(settings, report);
}

void build(const Settings&, Report& report) {
    report.begin_part("build", "a fresh clone of what is committed");
    const TemporaryFolder folder;
    const fs::path clone = folder / "clone";
    const std::string grader = clone / "grader" / "grader";
    const double first =
        measure({"git", "clone", "--quiet", course::source_root(), clone})
            .seconds +
        measure({grader, "run", clone / "data" / "sample_class", "--out",
                 folder / "out"})
            .seconds;
    report.add({"clone, build, first report", {first}, "s", 240.0});
    std::ofstream(
        clone / "grader" / "suites" / "01_traversal" / "face_sides_test.cpp",
        std::ios::app)
        << "// touched\n";
    const double again = measure({grader, "--help"}).seconds;
    report.add({"rebuild after one hidden suite", {again}, "s", 10.0});
}

}  // namespace grader::bench
