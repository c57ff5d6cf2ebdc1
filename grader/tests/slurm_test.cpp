// Grading on a cluster: first its parts by themselves, then all of it on a
// Slurm of one node that the test starts. SLURM=all in the environment has the
// whole sample class judged there, too.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <thread>

#include "course/runner/codec.h"
#include "course/runner/temporary_folder.h"
#include "grader/pipeline/keys.h"
#include "grader/pipeline/slurm_chunk.h"
#include "grader/pipeline/slurm_executor.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"
#include "grader/tests/process_stat.h"

namespace fs = std::filesystem;

using namespace grader;
using namespace grader::tests;
using namespace std::chrono_literals;
using course::ExerciseResult;
using course::Verdict;

namespace {

// ---- without a cluster: tasks whose results say what was judged

const course::Exercise& tip() {
    static const course::Exercise exercise = course::exercise_named("tip");
    return exercise;
}

Tasks numbered_tasks(std::size_t count) {
    return {count, [](std::size_t k) {
                return Task{&tip(), fmt::format("source {}", k)};
            }};
}

ExerciseResult result_for(const std::string& source,
                          Verdict verdict = Verdict::accepted) {
    ExerciseResult result;
    result.verdict = verdict;
    result.message = source;
    return result;
}

/// Judges like a node that works well.
void judge_well(const JobFolder& folder, const Job& job, std::size_t task) {
    const std::string source = folder.source(task, job.tasks[task]);
    folder.write_result(task, job.tasks[task], result_for(source));
}

/// What a made-up cluster does, and what is seen of it.
struct Cluster {
    using Judge = std::function<void(const JobFolder&, const Job&,
                                     std::size_t task, std::size_t round)>;
    Judge judge;
    std::vector<std::size_t> submitted;  ///< tasks of each job
    std::vector<std::size_t> chunks;
    std::vector<std::string> cancelled;
    bool ends = true;  ///< jobs end; otherwise they run for ever
    std::size_t most_chunks = 1000;
};

class MadeUpQueue : public Queue {
public:
    explicit MadeUpQueue(Cluster& cluster) : cluster_(cluster) {}

    std::size_t most_chunks() override { return cluster_.most_chunks; }
    void submit(const fs::path& path, std::size_t chunks) override {
        const JobFolder folder(path);
        const Job job = folder.job().value();
        CHECK(chunks == job.chunks());
        cluster_.chunks.push_back(chunks);
        cluster_.submitted.push_back(job.tasks.size());
        for (std::size_t task = 0; task < job.tasks.size(); ++task)
            cluster_.judge(folder, job, task, cluster_.submitted.size());
    }
    QueueState state(const std::string&) override {
        return {
            cluster_.ends ? QueueState::Kind::gone : QueueState::Kind::running,
            ""};
    }
    void cancel(const std::string& name) override {
        cluster_.cancelled.push_back(name);
        cluster_.ends = true;
    }

private:
    Cluster& cluster_;
};

/// What came of tasks on a made-up cluster, in `folder`.
struct Outcome {
    std::map<std::size_t, ExerciseResult> results;
    std::vector<std::string> said;
};

Outcome judge_on(
    Cluster& cluster, const fs::path& folder, const Tasks& tasks,
    const std::function<bool()>& stop = [] { return false; },
    std::size_t chunk = 2) {
    Outcome outcome;
    SlurmOptions options;
    options.chunk = chunk;
    options.grace = 0ms;
    options.say = [&](const std::string& text) {
        outcome.said.push_back(text);
    };
    SlurmExecutor executor(folder, {}, std::make_unique<MadeUpQueue>(cluster),
                           options);
    executor.judge(
        tasks,
        [&](std::size_t task, const ExerciseResult& result) {
            CHECK(outcome.results.emplace(task, result).second);
        },
        stop);
    return outcome;
}

/// Each task has the result of its own source.
void check_all_right(const Outcome& outcome, std::size_t count) {
    REQUIRE(outcome.results.size() == count);
    for (const auto& [task, result] : outcome.results) {
        CHECK(result.verdict == Verdict::accepted);
        CHECK(result.message == fmt::format("source {}", task));
    }
}

/// A job as the head writes it, for tests of what nodes do.
struct WrittenJob {
    course::TemporaryFolder parent;
    JobFolder folder = JobFolder::make(parent.path());
    Job job;

    explicit WrittenJob(std::size_t tasks, std::size_t chunk = 100) {
        job.chunk = chunk;
        for (std::size_t k = 0; k < tasks; ++k) {
            const std::string source = fmt::format("source {}", k);
            folder.write_source(k, source);
            job.tasks.push_back({tip().full_name(), sha256(source)});
        }
        job.build = build_version(exercises_of(job));
        folder.write(job);
    }
    fs::path result_file(std::size_t task) const {
        return folder.path() / "results" / std::to_string(task);
    }
};

class MadeUpExecutor : public Executor {
public:
    std::vector<std::string> judged;

    void judge(const Tasks& tasks, const TakeResult& take,
               const std::function<bool()>& stop) override {
        for (std::size_t k = 0; k < tasks.count && !stop(); ++k) {
            judged.push_back(tasks.at(k).source);
            take(k, result_for(judged.back()));
        }
    }
};

void overwrite(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("a result comes back from the folder as it was, rubbish does not") {
    const WrittenJob made(2);
    const JobFolder& folder = made.folder;
    const JobTask& listed = made.job.tasks[1];
    CHECK_FALSE(folder.result(1, listed));
    ExerciseResult result = result_for("said", Verdict::wrong_answer);
    result.cases.resize(2);
    result.cases[1].failures.resize(1);
    result.cases[1].failures[0].got = "7";
    folder.write_result(1, listed, result);
    REQUIRE(folder.result(1, listed));
    CHECK(
        (course::encode(*folder.result(1, listed)) == course::encode(result)));
    CHECK(folder.results() == std::vector<std::size_t>{1});
    const std::string bytes = file_contents(made.result_file(1));

    SECTION("that of another source") {
        CHECK_FALSE(folder.result(1, made.job.tasks[0]));
    }
    SECTION("that of another task") {
        overwrite(made.result_file(0), bytes);
        CHECK_FALSE(folder.result(0, listed));
    }
    SECTION("cut short anywhere") {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            overwrite(made.result_file(1), bytes.substr(0, size));
            REQUIRE_FALSE(folder.result(1, listed));
        }
    }
    SECTION("any byte changed") {
        for (std::size_t k = 0; k < bytes.size(); ++k) {
            std::string changed = bytes;
            changed[k] = static_cast<char>(changed[k] ^ 0x20);
            overwrite(made.result_file(1), changed);
            REQUIRE_FALSE(folder.result(1, listed));
        }
    }
}

TEST_CASE("a source that is not the listed one is never judged") {
    const WrittenJob made(1);
    CHECK(made.folder.source(0, made.job.tasks[0]) == "source 0");
    overwrite(made.folder.path() / "sources/0", "source 1");
    CHECK_THROWS_AS(made.folder.source(0, made.job.tasks[0]),
                    course::SystemError);
}

TEST_CASE("a chunk judges its tasks, and those that have a result not again") {
    const WrittenJob made(7, 3);
    made.folder.write_result(4, made.job.tasks[4], result_for("there before"));
    overwrite(made.result_file(5), "rubbish");
    MadeUpExecutor executor;
    CHECK(
        judge_chunk(made.folder, made.job, 1, executor, [] { return false; }));
    CHECK(executor.judged == std::vector<std::string>{"source 3", "source 5"});
    CHECK(made.folder.result(3, made.job.tasks[3])->message == "source 3");
    CHECK(made.folder.result(4, made.job.tasks[4])->message == "there before");
    CHECK(made.folder.result(5, made.job.tasks[5])->message == "source 5");
    CHECK(made.folder.results().size() == 3);
}

TEST_CASE("what ends while the cluster disturbs the chunk is no result") {
    const WrittenJob made(3);
    MadeUpExecutor executor;
    // A submission was killed with the chunk; the chunk learns it later.
    const auto done_at = course::Clock::now();
    const auto disturbed = [&] {
        return course::Clock::now() > done_at + settling_time / 2;
    };
    CHECK_FALSE(judge_chunk(made.folder, made.job, 0, executor, disturbed));
    CHECK(made.folder.results().empty());
}

TEST_CASE("each task gets its own result, and the folder is gone") {
    const course::TemporaryFolder out;
    Cluster cluster;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task,
                       std::size_t) { judge_well(folder, job, task); };
    SECTION("in chunks of the size that was asked for") {
        check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(7)), 7);
        CHECK(cluster.chunks == std::vector<std::size_t>{4});
    }
    SECTION("in as many chunks as the cluster takes") {
        cluster.most_chunks = 3;
        check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(7)), 7);
        CHECK(cluster.chunks == std::vector<std::size_t>{3});
    }
    SECTION("nothing to do is nothing submitted") {
        check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(0)), 0);
        CHECK(cluster.submitted.empty());
    }
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("what a job leaves undone is handed out again, and only that") {
    const course::TemporaryFolder out;
    Cluster cluster;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task, std::size_t round) {
        if (round == 2 || task % 4 != 1) return judge_well(folder, job, task);
        const fs::path results = folder.path() / "results";
        if (task == 5) overwrite(results / "5", "rubbish of a dying node");
        overwrite(results / ".1-node-77", "never finished");
        overwrite(results / "99999", "of no task");
    };
    check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(10)), 10);
    CHECK(cluster.submitted == std::vector<std::size_t>{10, 3});
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("after three jobs without a result it is a fault that says why") {
    const course::TemporaryFolder out;
    Cluster cluster;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task, std::size_t round) {
        const std::string source = folder.source(task, job.tasks[task]);
        if (source != "source 1" && source != "source 3")
            return judge_well(folder, job, task);
        const auto chunk = task / static_cast<std::size_t>(job.chunk);
        overwrite(folder.path() / "log" / std::to_string(chunk),
                  fmt::format("{}: fire, for the {}. time", source, round));
    };
    const Outcome outcome = judge_on(cluster, out / "slurm", numbered_tasks(5));
    CHECK(cluster.submitted == std::vector<std::size_t>{5, 2, 2});
    REQUIRE(outcome.results.size() == 5);
    for (const std::size_t task : {1u, 3u}) {
        const ExerciseResult& fault = outcome.results.at(task);
        CHECK(fault.verdict == Verdict::grader_fault);
        CHECK(fault.message ==
              fmt::format("the cluster gave no result: source {}: fire, for "
                          "the 3. time",
                          task));
    }
    // There is something to learn from that folder, and it is named.
    REQUIRE(fs::exists(out / "slurm"));
    CHECK(contains(outcome.said.back(), (out / "slurm").string()));
}

TEST_CASE("a grader fault is judged once more, elsewhere") {
    const course::TemporaryFolder out;
    std::size_t faults = 0;
    SECTION("and may pass") {
        faults = 1;
    }
    SECTION("and may stay") {
        faults = 9;
    }
    Cluster cluster;
    cluster.judge = [&](const JobFolder& folder, const Job& job,
                        std::size_t task, std::size_t round) {
        if (folder.source(task, job.tasks[task]) == "source 1" &&
            round <= faults)
            folder.write_result(task, job.tasks[task],
                                result_for(fmt::format("fault {}", round),
                                           Verdict::grader_fault));
        else
            judge_well(folder, job, task);
    };
    const Outcome outcome = judge_on(cluster, out / "slurm", numbered_tasks(3));
    CHECK(cluster.submitted == std::vector<std::size_t>{3, 1});
    if (faults == 1) return check_all_right(outcome, 3);
    REQUIRE(outcome.results.size() == 3);
    CHECK(outcome.results.at(1).verdict == Verdict::grader_fault);
    CHECK(outcome.results.at(1).message == "fault 2");
}

TEST_CASE("a stop cancels the job, takes what is there, leaves no folder") {
    const course::TemporaryFolder out;
    Cluster cluster;
    cluster.ends = false;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task, std::size_t) {
        if (task < 3) judge_well(folder, job, task);
    };
    const auto stop = [&] { return !cluster.submitted.empty(); };
    const Outcome outcome =
        judge_on(cluster, out / "slurm", numbered_tasks(5), stop);
    check_all_right(outcome, 3);
    CHECK(cluster.submitted.size() == 1);
    CHECK(cluster.cancelled.size() == 1);
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("an error of the gradebook ends the job and keeps its results") {
    const course::TemporaryFolder out;
    Cluster cluster;
    cluster.ends = false;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task,
                       std::size_t) { judge_well(folder, job, task); };
    SlurmExecutor executor(out / "slurm", {},
                           std::make_unique<MadeUpQueue>(cluster), {});
    const auto disk_is_full = [](std::size_t, const ExerciseResult&) {
        throw std::runtime_error("disk full");
    };
    CHECK_THROWS_WITH(
        executor.judge(numbered_tasks(3), disk_is_full, [] { return false; }),
        "disk full");
    CHECK(cluster.cancelled.size() == 1);
    cluster.submitted.clear();
    check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(3)), 3);
    CHECK(cluster.submitted.empty());
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("of a killed head's job only results as good as new are taken") {
    const course::TemporaryFolder out;
    const WrittenJob made(4);
    const fs::path left = out / "slurm/grader-abc";
    Cluster cluster;
    cluster.judge = [](const JobFolder& folder, const Job& job,
                       std::size_t task,
                       std::size_t) { judge_well(folder, job, task); };
    const auto leave = [&](const Job& job) {
        made.folder.write(job);
        for (std::size_t k : {0u, 2u}) judge_well(made.folder, job, k);
        const ExerciseResult fault = result_for("x", Verdict::grader_fault);
        made.folder.write_result(3, job.tasks[3], fault);
        fs::create_directories(left.parent_path());
        fs::copy(made.folder.path(), left, fs::copy_options::recursive);
    };
    std::size_t expected = 2;
    Job job = made.job;
    SECTION("judged as this one judges") {}
    SECTION("judged with another seed") {
        job.conditions.seed = 2;
        expected = 4;
    }
    SECTION("judged under another isolation") {
        job.conditions.isolation = Isolation::landlock;
        expected = 4;
    }
    SECTION("judged under other limits") {
        job.limits[tip().full_name()].memory_mib = 64;
        job.build = build_version(exercises_of(job));
        expected = 4;
    }
    SECTION("judged by another build") {
        job.build = "older";
        expected = 4;
    }
    leave(job);
    check_all_right(judge_on(cluster, out / "slurm", numbered_tasks(4)), 4);
    CHECK(cluster.submitted == std::vector<std::size_t>{expected});
    REQUIRE_FALSE(cluster.cancelled.empty());
    CHECK(cluster.cancelled[0] == "grader-abc");
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("a node that would judge otherwise than the head does not judge") {
    WrittenJob made(1);
    std::string why;
    SECTION("with another build") {
        why = "would judge otherwise";
    }
    SECTION("that has no such exercise") {
        made.job.tasks[0].exercise = "01_traversal/no_such";
        why = "no_such";
    }
    made.folder.write(made.job);
    const Said said = grader_says({"work", made.folder.path(), "0"});
    INFO(said.text);
    CHECK(said.code == 2);
    CHECK(contains(said.text, why));
    CHECK(contains(said.text, "Nothing was judged"));
    CHECK(made.folder.results().empty());
}

// ---- with a cluster: this machine

namespace {

course::Command script(const char* name,
                       const std::vector<std::string>& arguments) {
    course::Command command;
    command.arguments = {course::source_root() / "grader/tests/slurm" / name};
    command.arguments.insert(command.arguments.end(), arguments.begin(),
                             arguments.end());
    command.environment = course::plain_environment();
    return command;
}

/// A Slurm of one node, for as long as the test runs.
class SlurmHere {
public:
    SlurmHere() : up_(says(script("up", {dir_, std::to_string(::getpid())}))) {}
    SlurmHere(const SlurmHere&) = delete;
    SlurmHere& operator=(const SlurmHere&) = delete;
    ~SlurmHere() {
        course::run(script("down", {dir_}), 60s, std::size_t{1} << 16);
    }

    const Said& up() const { return up_; }

    /// A command that knows where it is, and does not outlive this process.
    course::Command command(const std::vector<std::string>& arguments) const {
        course::Command command;
        command.arguments = {"setpriv", "--pdeathsig", "KILL", "--"};
        command.arguments.insert(command.arguments.end(), arguments.begin(),
                                 arguments.end());
        command.environment = course::plain_environment();
        command.environment.push_back(
            fmt::format("SLURM_CONF={}/slurm.conf", dir_.string()));
        return command;
    }
    std::string queue(const char* format = "%i") const {
        const Said said = says(command(
            {"squeue", "--noheader", "--array", fmt::format("-o{}", format)}));
        REQUIRE(said.code == 0);
        return said.text;
    }

private:
    course::TemporaryFolder folder_;
    fs::path dir_ = folder_ / "slurm";
    Said up_;
};

/// Nothing where this machine cannot have one.
const SlurmHere* slurm_here() {
    static const SlurmHere slurm;
    static const bool is_sandboxed = has_sandbox();
    if (slurm.up().code == 77) WARN("skipped: " << slurm.up().text);
    if (slurm.up().code == 77 || !is_sandboxed) return nullptr;
    INFO(slurm.up().text);
    REQUIRE(slurm.up().code == 0);
    return &slurm;
}

/// Four students with three files each: right ones, one wrong, one that does
/// not compile, one that never ends.
struct SmallClass {
    course::TemporaryFolder folder;
    fs::path dir = folder / "class";

    SmallClass() {
        for (const char* student : {"anna", "bruno", "carla", "dario"})
            for (const char* name : {"face_sides", "tip", "vertex_degree"})
                hand_in(student, course::exercise_named(name));
        const fs::path loop =
            course::source_root() /
            "grader/wrong/01_traversal/face_sides/time_limit_exceeded";
        fs::copy_file(fs::directory_iterator(loop)->path(),
                      dir / "bruno/face_sides.cpp",
                      fs::copy_options::overwrite_existing);
        fs::copy_file(course::exercise_named("tip").skeleton(),
                      dir / "carla/tip.cpp",
                      fs::copy_options::overwrite_existing);
        std::ofstream(dir / "dario/vertex_degree.cpp", std::ios::app)
            << "int x = ;";
    }

    void hand_in(const fs::path& student, const course::Exercise& exercise) {
        fs::create_directories(dir / student);
        fs::copy_file(exercise.solution(),
                      dir / student / exercise.file_name());
    }
};

constexpr int submitted = 12;

using Words = std::vector<std::string>;

/// `grader run`, for a class and a folder of results.
Words run_of(const fs::path& dir, const fs::path& out, const Words& more) {
    Words words = {course::build_root() / "grader" / "grader", "run", dir,
                   "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
Words on_slurm(const fs::path& dir, const fs::path& out,
               const std::string& chunk) {
    return run_of(dir, out,
                  {"--executor", "slurm", "--chunk", chunk, "--grace", "1"});
}

/// Everything that people get, by name, times apart.
std::map<std::string, std::string> files_in(const fs::path& out) {
    static const std::regex times("[0-9]{4}-[0-9]{2}-[0-9]{2}[T ][0-9:]+");
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(out))
        if (entry.is_regular_file() && entry.path().extension() != ".sqlite")
            files[fs::relative(entry.path(), out)] = std::regex_replace(
                file_contents(entry.path()), times, "(time)");
    return files;
}

void check_same_files(const fs::path& out, const fs::path& local) {
    const auto got = files_in(out), expected = files_in(local);
    CHECK(got.size() == expected.size());
    for (const auto& [name, bytes] : expected) {
        const auto found = got.find(name);
        INFO(name);
        REQUIRE(found != got.end());
        INFO(first_difference(bytes, found->second));
        CHECK((found->second == bytes));
    }
}

/// The class, and what it gets on this machine without a cluster.
struct Graded {
    SmallClass submissions;
    fs::path out = submissions.folder / "local";

    Graded() {
        course::Command command;
        command.arguments = run_of(submissions.dir, out, {});
        command.environment = course::plain_environment();
        const Said said = says(command);
        INFO(said.text);
        REQUIRE(said.code == 0);
    }
};

const Graded& graded_here() {
    static const Graded graded;
    return graded;
}

void check_complete(const fs::path& out) {
    check_same_files(out, graded_here().out);
    SQLite::Database book(out / "gradebook.sqlite", SQLite::OPEN_READWRITE);
    CHECK(book.execAndGet("SELECT count(*) FROM attempts WHERE key <> 'not "
                          "submitted'")
              .getInt() == submitted);
}

/// The verdict on each case of each student, as text.
std::string verdicts_in(const fs::path& out) {
    SQLite::Database book(out / "gradebook.sqlite", SQLite::OPEN_READWRITE);
    SQLite::Statement rows(
        book,
        "SELECT s.student, s.exercise, s.verdict, s.points, c.name, c.verdict "
        "FROM standing s LEFT JOIN cases c ON c.attempt = s.attempt "
        "ORDER BY s.student, s.exercise, c.position");
    std::string text;
    while (rows.executeStep()) {
        for (int k = 0; k < rows.getColumnCount(); ++k)
            text += rows.getColumn(k).getString() + "|";
        text += "\n";
    }
    return text;
}

/// A program whose output goes to a file.
class Started {
public:
    explicit Started(course::Command command)
        : process_(to_file(std::move(command))) {}

    /// Its exit code, or -1 when it was killed.
    int wait() {
        const int status = process_.wait();
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string text() const { return file_contents(folder_ / "text"); }

private:
    course::Command to_file(course::Command command) {
        text_ = course::Descriptor(::open(
            (folder_ / "text").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
        command.descriptors = {{text_.get(), 1}, {text_.get(), 2}};
        return command;
    }
    course::TemporaryFolder folder_;
    course::Descriptor text_;
    course::Process process_;
};

/// Polls until something holds that must come to hold.
void wait_until(const std::function<bool()>& holds) {
    const auto limit = course::Clock::now() + 60s;
    while (!holds()) {
        REQUIRE(course::Clock::now() < limit);
        std::this_thread::sleep_for(10ms);
    }
}

/// Nothing of a process that ended in between.
std::string command_line(const fs::path& process) {
    try {
        return file_contents(process / "cmdline");
    } catch (const std::ios_base::failure&) {
        return "";
    }
}

/// Graders on this machine with that subcommand and something below `out`; not
/// what they have forked, which bears the same command line.
std::vector<pid_t> graders(const std::string& subcommand, const fs::path& out) {
    std::map<pid_t, pid_t> parents;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string line = command_line(entry.path());
        const std::string begin =
            (course::build_root() / "grader/grader").string() + '\0' +
            subcommand + '\0';
        if (line.rfind(begin, 0) != 0 || !contains(line, out.string()))
            continue;
        if (const auto stat = process_stat(entry.path()))
            parents[std::stoi(entry.path().filename())] = stat->parent;
    }
    std::vector<pid_t> found;
    for (const auto& [process, parent] : parents)
        if (!parents.contains(parent)) found.push_back(process);
    return found;
}

/// The only job in `out`; its path is empty while there is none.
JobFolder job_below(const fs::path& out) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(out / "slurm", none))
        return JobFolder(entry.path());
    return JobFolder(fs::path());
}

bool has_result(const fs::path& out) {
    return !job_below(out).results().empty();
}

}  // namespace

TEST_CASE("a class gets from a cluster, byte for byte, what it gets here") {
    const SlurmHere* slurm = slurm_here();
    if (slurm == nullptr) return;
    const SmallClass& submissions = graded_here().submissions;
    const fs::path out = submissions.folder / "it's 100 %a cluster";
    const Said said = says(slurm->command(on_slurm(submissions.dir, out, "5")));
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(contains(said.text, "12 tasks in 3 chunks"));
    CHECK(contains(said.text, "12 submissions were graded"));
    check_complete(out);
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("chunks that are killed and cancelled are done again, all the same") {
    const SlurmHere* slurm = slurm_here();
    if (slurm == nullptr) return;
    const SmallClass& submissions = graded_here().submissions;
    const fs::path out = submissions.folder / "killed";
    Started head(slurm->command(on_slurm(submissions.dir, out, "6")));
    wait_until([&] { return !graders("work", out).empty(); });
    const std::vector<pid_t> chunks = graders("work", out);
    REQUIRE_FALSE(chunks.empty());
    // Or it might have done its work before it is killed.
    ::kill(chunks[0], SIGSTOP);
    wait_until([&] { return has_result(out); });
    ::kill(chunks[0], SIGKILL);
    for (std::istringstream jobs(slurm->queue()); jobs;) {
        std::string job;
        if (jobs >> job && job.ends_with("_1"))
            CHECK(says(slurm->command({"scancel", job})).code == 0);
    }
    const int code = head.wait();
    INFO(head.text());
    CHECK(code == 0);
    CHECK(contains(head.text(), "which had no result before"));
    check_complete(out);
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE(
    "a head that is interrupted leaves no job, and a killed one no loss") {
    const SlurmHere* slurm = slurm_here();
    if (slurm == nullptr) return;
    const SmallClass& submissions = graded_here().submissions;
    const fs::path out = submissions.folder / "stopped";
    const auto command = slurm->command(on_slurm(submissions.dir, out, "12"));
    {
        Started head(command);
        wait_until([&] { return has_result(out); });
        for (const pid_t pid : graders("run", out)) ::kill(pid, SIGINT);
        const int code = head.wait();
        INFO(head.text());
        CHECK(code == 1);
        CHECK(contains(head.text(), "Stopped before the end"));
        CHECK_FALSE(fs::exists(out / "slurm"));
    }
    {
        Started head(command);
        wait_until([&] { return has_result(out); });
        for (const pid_t pid : graders("run", out)) ::kill(pid, SIGKILL);
        CHECK(head.wait() == -1);
        CHECK(has_result(out));
    }
    const Said said = says(slurm->command(on_slurm(submissions.dir, out, "2")));
    INFO(said.text);
    CHECK(said.code == 0);
    check_complete(out);
    CHECK_FALSE(fs::exists(out / "slurm"));
}

TEST_CASE("a node without the head's isolation judges nothing and says why") {
    const SlurmHere* slurm = slurm_here();
    if (slurm == nullptr) return;
    const SmallClass& submissions = graded_here().submissions;
    const fs::path out = submissions.folder / "held";
    auto words = on_slurm(submissions.dir, out, "12");
    words.push_back("--sbatch=--hold");
    Started head(slurm->command(words));
    wait_until([&] { return !slurm->queue().empty(); });
    const course::TemporaryFolder copy;
    const JobFolder job(copy / "job");
    fs::copy(job_below(out).path(), job.path(), fs::copy_options::recursive);
    for (const pid_t pid : graders("run", out)) ::kill(pid, SIGINT);
    CHECK(head.wait() == 1);
    // Nobody but the head would have ended what was held.
    CHECK(slurm->queue().empty());

    // A node with all that the grader needs beside its sandbox.
    fs::create_directory(copy / "bin");
    fs::create_symlink("/usr/bin/ldd", copy / "bin/ldd");
    course::Command work = grader_command({"work", job.path(), "0"});
    work.environment = {"PATH=" + (copy / "bin").string()};
    const bool had_bubblewrap =
        job.job().value().conditions.isolation == Isolation::bubblewrap;
    const Said without = says(work);
    INFO(without.text);
    if (had_bubblewrap) {
        CHECK(without.code == 2);
        CHECK(contains(without.text, "does not offer --isolation bubblewrap"));
        CHECK(job.results().empty());
    }
    // And one that has it.
    const Said with = grader_says({"work", job.path(), "0"});
    INFO(with.text);
    CHECK(with.code == 0);
    CHECK(job.results().size() == submitted);
}

TEST_CASE("the sample class gets the same grades from a cluster, SLURM=all") {
    const char* wanted = std::getenv("SLURM");
    if (wanted == nullptr || std::string(wanted) != "all") return;
    const SlurmHere* slurm = slurm_here();
    if (slurm == nullptr) return;
    const fs::path dir = course::source_root() / "data/sample_class";
    const course::TemporaryFolder folder;
    const fs::path out = folder / "cluster", local = folder / "local";
    const Said said = says(slurm->command(on_slurm(dir, out, "40")));
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(grader_says({"run", dir, "--out", local}).code == 0);
    // What its hostile students print is another time cut off elsewhere.
    for (const char* name : {"grades.csv", "report.html"}) {
        const auto expected = files_in(local).at(name);
        const auto got = files_in(out).at(name);
        INFO(name << ", " << first_difference(expected, got));
        CHECK((got == expected));
    }
    INFO(first_difference(verdicts_in(local), verdicts_in(out)));
    CHECK((verdicts_in(out) == verdicts_in(local)));
}
