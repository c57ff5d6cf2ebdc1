// The class of data/sample_class is graded as its expected verdicts say, by the
// program itself; what its students try stays without effect.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <thread>

#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/report/class_results.h"
#include "grader/tests/golden.h"
#include "grader/tests/process_stat.h"

using namespace grader;
using namespace grader::tests;
using namespace std::chrono_literals;

namespace fs = std::filesystem;

namespace {

const fs::path class_folder = fs::path(COURSE_SOURCE_DIR) / "data/sample_class";
const fs::path expected_file =
    fs::path(COURSE_SOURCE_DIR) / "data/sample_class_expected.csv";

// ---- the program

course::Command run_command(const fs::path& out) {
    course::Command command;
    command.arguments = {fs::path(COURSE_BINARY_DIR) / "grader/grader", "run",
                         class_folder, "--out", out};
    command.environment = course::plain_environment();
    return command;
}

bool ended_well(const course::Finished& finished) {
    return !finished.timed_out && WIFEXITED(finished.status) &&
           WEXITSTATUS(finished.status) == 0;
}

// ---- its processes: one that loses its parent becomes ours (see SharedRun),
// so that none that a run leaves behind can hide

struct Child {
    long long started;  ///< in ticks of the system's clock
    pid_t process;
    std::string name;
    bool ended;  ///< and nobody has asked for its status yet

    auto operator<=>(const Child&) const = default;
};

/// The children of this process, oldest first.
std::vector<Child> children() {
    std::vector<Child> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string number = entry.path().filename().string();
        if (number.find_first_not_of("0123456789") != number.npos) continue;
        const auto stat = process_stat(entry.path());
        if (stat && stat->parent == getpid())
            found.push_back({stat->started, std::stoi(number), stat->name,
                             stat->state == 'Z'});
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Takes the status of those that have ended, as init does with orphans: until
/// then they count as processes of their user, who may have only a few.
void bury(const std::vector<Child>& orphans) {
    for (const Child& child : orphans)
        if (child.ended) waitpid(child.process, nullptr, WNOHANG);
}

/// Buries the orphans of a grader that is waited for elsewhere. Precondition:
/// there are no children yet, so that the oldest is the grader.
class Undertaker {
    std::jthread thread_{[](const std::stop_token& stop) {
        for (; !stop.stop_requested(); std::this_thread::sleep_for(100ms)) {
            std::vector<Child> all = children();
            if (!all.empty()) all.erase(all.begin());
            bury(all);
        }
    }};
};

/// Those that still run after the longest time that a case may take.
std::vector<std::string> processes_left() {
    const auto until = course::Clock::now() + 8s;
    for (;; std::this_thread::sleep_for(50ms)) {
        bury(children());
        std::vector<std::string> names;
        for (const Child& child : children()) names.push_back(child.name);
        if (names.empty() || course::Clock::now() > until) return names;
    }
}

course::Finished grade(const fs::path& out) {
    const Undertaker undertaker;
    return course::run(run_command(out), 300s, 1u << 20);
}

/// Starts a run and kills it.
void kill_after(std::chrono::milliseconds time, const fs::path& out) {
    const Undertaker undertaker;
    course::Process process(run_command(out));
    std::this_thread::sleep_for(time);
    process.kill();
    const int status = process.wait();
    REQUIRE(WIFSIGNALED(status));
}

// ---- what a run may not touch

/// Names below `folder` with the size and time of each file.
std::set<std::string> listing(const fs::path& folder) {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        found.insert(
            fmt::format("{} {} {}", entry.path().string(),
                        entry.is_regular_file() ? entry.file_size() : 0,
                        entry.last_write_time().time_since_epoch().count()));
    return found;
}

/// Where the students of the class try to leave a file.
std::set<std::string> forged_files() {
    std::set<std::string> found;
    for (const fs::path& folder :
         {fs::temp_directory_path(), fs::path("/var/tmp"), fs::path("/dev/shm"),
          fs::current_path(), fs::current_path().parent_path(), class_folder})
        for (const char* name : {"results.json", "report.html", "grades.csv",
                                 "smith_john2_was_here"})
            if (fs::exists(folder / name))
                found.insert((folder / name).string());
    return found;
}

// ---- the run that the cases share

struct SharedRun {
    course::TemporaryFolder folder;
    fs::path out = folder / "out";
    std::set<std::string> class_before = listing(class_folder);
    std::set<std::string> forged_before = forged_files();
    course::Finished finished;
    std::vector<std::string> left_behind;

    SharedRun() {
        prctl(PR_SET_CHILD_SUBREAPER, 1);
        finished = grade(out);
        left_behind = processes_left();
    }
};

const SharedRun& shared_run() {
    static const SharedRun run;
    return run;
}

/// Without an assignment: those of the chapters of which it handed in a file.
std::vector<course::Exercise> exercises_of_the_class() {
    std::vector<course::Exercise> exercises = course::all_exercises();
    std::erase_if(exercises, [](const course::Exercise& exercise) {
        return exercise.topic > "02_border";
    });
    return exercises;
}

ClassResults results_in(const fs::path& out) {
    std::vector<std::string> names;
    for (const course::Exercise& exercise : exercises_of_the_class())
        names.push_back(exercise.full_name());
    const Gradebook book(out / "gradebook.sqlite", Gradebook::Access::read);
    return class_results(book, default_assignment(names));
}

/// "\"name\",\"exercise\",\"verdict\",points": a row as in the expected file.
std::string row(const std::string& student, std::string_view exercise,
                const course::ExerciseResult& result) {
    std::string quoted;
    for (const char c : student)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return fmt::format("\"{}\",\"{}\",\"{}\",{:g}", quoted, exercise,
                       name(result.verdict), result.points());
}

std::multiset<std::string> rows_of(const ClassResults& results) {
    std::multiset<std::string> rows;
    for (const StudentResults& student : results.students)
        for (std::size_t k = 0; k < student.exercises.size(); ++k) {
            const auto& result = student.exercises[k];
            REQUIRE(result.has_value());
            if (was_judged(result) ||
                result->verdict == course::Verdict::grader_fault)
                rows.insert(row(student.student.name,
                                short_name(results.exercises[k].exercise),
                                *result));
        }
    return rows;
}

std::multiset<std::string> expected_rows() {
    std::istringstream in(file_contents(expected_file));
    std::multiset<std::string> rows;
    std::string line;
    std::getline(in, line);
    REQUIRE(line == "student,exercise,verdict,points");
    while (std::getline(in, line)) rows.insert(line);
    return rows;
}

/// The rows of `a` that `b` has not, one on each line.
std::string without(const std::multiset<std::string>& a,
                    const std::multiset<std::string>& b) {
    std::vector<std::string> only;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                        std::back_inserter(only));
    return fmt::format("{}", fmt::join(only, "\n"));
}

}  // namespace

TEST_CASE("the sample class is graded without a fault") {
    INFO(shared_run().finished.output);
    CHECK(ended_well(shared_run().finished));
}

TEST_CASE(
    "every submission of the class gets its expected verdict and points") {
    const auto got = rows_of(results_in(shared_run().out));
    const auto expected = expected_rows();
    CHECK(without(expected, got) == "");
    CHECK(without(got, expected) == "");
}

TEST_CASE("the class has students enough, and each is in the results") {
    std::set<std::string> folders, names;
    for (const auto& entry : fs::directory_iterator(class_folder))
        folders.insert(entry.path().filename().string());
    for (const auto& student : results_in(shared_run().out).students)
        names.insert(student.student.name);
    CHECK(folders == names);
    CHECK(names.size() >= 18);
}

TEST_CASE("the grades have a column for each exercise and a row per student") {
    std::string header = "student,total,max,percent,status";
    for (const course::Exercise& exercise : exercises_of_the_class())
        header += "," + exercise.name;
    const std::string grades = file_contents(shared_run().out / "grades.csv");
    CHECK(grades.substr(0, grades.find('\n')) == header);
    const auto lines = std::count(grades.begin(), grades.end(), '\n');
    CHECK(static_cast<std::size_t>(lines) ==
          1 + results_in(shared_run().out).students.size());
}

TEST_CASE("the class and each student have their reports") {
    const fs::path out = shared_run().out;
    CHECK(fs::file_size(out / "report.html") > 0);
    for (const auto& student : results_in(out).students)
        for (const char* name :
             {"feedback.html", "results.json", "junit.xml"}) {
            const fs::path file = out / "students" / student.student.id / name;
            INFO(file.string());
            REQUIRE(fs::is_regular_file(file));
            CHECK(fs::file_size(file) > 0);
        }
}

TEST_CASE("a second run judges nothing and says so") {
    const std::string grades = file_contents(shared_run().out / "grades.csv");
    const course::Finished again = grade(shared_run().out);
    INFO(again.output);
    CHECK(ended_well(again));
    CHECK_THAT(again.output,
               Containing(fmt::format("{} submissions were unchanged and not "
                                      "graded again.",
                                      expected_rows().size())));
    CHECK_THAT(again.output, Containing("\n0 submissions were graded."));
    CHECK((file_contents(shared_run().out / "grades.csv") == grades));
}

TEST_CASE("no student writes outside of the folder of the results") {
    CHECK(listing(class_folder) == shared_run().class_before);
    CHECK(forged_files() == shared_run().forged_before);
}

TEST_CASE("no process of a run is left") {
    CHECK(shared_run().left_behind == std::vector<std::string>());
}

TEST_CASE("a run that was killed goes on, to the same grades") {
    const std::string grades = file_contents(shared_run().out / "grades.csv");
    const course::TemporaryFolder folder;
    const fs::path out = folder / "out";
    const auto seed = std::random_device()();
    std::mt19937 random(seed);
    CAPTURE(seed);
    for (int k = 0; k < 3; ++k) {
        kill_after(std::uniform_int_distribution(100, 3000)(random) * 1ms, out);
        CHECK(processes_left() == std::vector<std::string>());
    }
    const course::Finished last = grade(out);
    INFO(last.output);
    CHECK(ended_well(last));
    CHECK((file_contents(out / "grades.csv") == grades));
    CHECK(without(rows_of(results_in(out)), expected_rows()) == "");
}
