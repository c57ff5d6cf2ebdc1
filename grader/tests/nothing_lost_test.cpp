// A grader that is killed, a disk that is full, a gradebook that somebody else
// holds, two graders at once: no grade is lost, invented or changed, and the
// next run goes on.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <regex>
#include <thread>

#include "course/runner/temporary_folder.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"

namespace fs = std::filesystem;

using namespace grader::tests;
using std::chrono::milliseconds;

namespace {

const std::vector<std::string> exercises = {"face_sides", "vertex_degree",
                                            "tip"};

/// Six students: two right, two wrong each in its way, one with nothing for an
/// exercise, one whose file does not compile.
void hand_in(const fs::path& dir) {
    for (int student = 0; student < 6; ++student) {
        const fs::path folder = dir / fmt::format("student{}", student);
        fs::create_directories(folder);
        for (const std::string& name : exercises) {
            const course::Exercise exercise = course::exercise_named(name);
            const fs::path right = exercise.solution();
            const fs::path to = folder / exercise.file_name();
            if (student == 4 && name == "tip") continue;
            fs::copy_file(
                student < 2 || student == 4 ? right : exercise.skeleton(), to);
            if (student == 5) std::ofstream(to, std::ios::app) << "int x = ;";
        }
    }
}

fs::path write_assignment(const fs::path& folder) {
    const fs::path file = folder / "assignment.toml";
    std::ofstream out(file);
    out << "name = \"Nothing lost\"\n[exercises]\n";
    for (const std::string& name : exercises) out << name << " = 1\n";
    return file;
}

/// What a class is graded with; each test has one of its own.
struct Class {
    course::TemporaryFolder folder;
    fs::path dir = folder / "class";
    fs::path assignment = write_assignment(folder.path());

    Class() { hand_in(dir); }

    std::vector<std::string> run(const fs::path& out, int jobs = 2) const {
        return {"run",          dir,        "--out",  out,
                "--assignment", assignment, "--jobs", std::to_string(jobs)};
    }
};

/// Everything that was graded, times apart, as text.
std::string standing(const fs::path& out) {
    SQLite::Database book(out / "gradebook.sqlite", SQLite::OPEN_READWRITE);
    std::string text;
    SQLite::Statement rows(
        book,
        "SELECT s.student, s.exercise, s.verdict, s.points, s.max, c.name, "
        "c.verdict, c.points, c.hint, hex(c.failures) FROM standing s LEFT "
        "JOIN cases c ON c.attempt = s.attempt "
        "ORDER BY s.student, s.exercise, c.position");
    while (rows.executeStep()) {
        for (int k = 0; k < rows.getColumnCount(); ++k)
            text += rows.getColumn(k).getString() + "|";
        text += "\n";
    }
    return text;
}

/// The files that people get, times apart.
std::string reports(const fs::path& out) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(out))
        if (entry.is_regular_file() && entry.path().extension() != ".sqlite")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string all;
    for (const fs::path& file : files)
        all += fs::relative(file, out).string() + "\n" + file_contents(file);
    static const std::regex times(
        "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]+Z?|<time>[^<]*</time>");
    return std::regex_replace(all, times, "(time)");
}

void check_same(const fs::path& out, const fs::path& undisturbed) {
    CHECK((standing(out) == standing(undisturbed)));
    CHECK((reports(out) == reports(undisturbed)));
}

/// No attempt of a submission is recorded twice.
void check_no_attempt_twice(const fs::path& out) {
    SQLite::Database book(out / "gradebook.sqlite", SQLite::OPEN_READWRITE);
    CHECK(book.execAndGet("SELECT count(*) FROM (SELECT 1 FROM attempts GROUP "
                          "BY student, exercise, key HAVING count(*) > 1)")
              .getInt() == 0);
}

/// The undisturbed run; made once.
const fs::path& undisturbed() {
    static const Class submitted;
    static const fs::path out = submitted.folder / "out";
    if (!fs::exists(out)) REQUIRE(grader_says(submitted.run(out)).code == 0);
    return out;
}

/// Runs a command as a child that can be killed.
pid_t start(const course::Command& command) {
    const pid_t pid = ::fork();
    REQUIRE(pid >= 0);
    if (pid > 0) return pid;
    std::vector<char*> arguments;
    for (const std::string& argument : command.arguments)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    std::freopen("/dev/null", "w", stdout);
    std::freopen("/dev/null", "w", stderr);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

int wait_for(pid_t pid) {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return status;
}

/// Processes on this machine that belong to a sandbox of this build.
int sandbox_processes() {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::error_code gone;
        const fs::path program = fs::read_symlink(entry.path() / "exe", gone);
        if (!gone && program.filename() == "grader_worker") ++count;
    }
    return count;
}

bool can_mount() {
    course::Command command;
    command.arguments = {"unshare", "--mount", "sh", "-c",
                         "mount -t tmpfs -o size=1m none /mnt"};
    command.environment = course::plain_environment();
    if (says(command).code == 0) return true;
    WARN("skipped: this user may not mount a small file system");
    return false;
}

/// `script` with $OUT, a folder on a file system of its own that only it sees,
/// and $RUN, the command that grades into it.
Said with_small_disk(const Class& submitted, const std::string& options,
                     const std::string& script) {
    const fs::path out = submitted.folder / "small";
    fs::create_directory(out);
    std::string run;
    for (const std::string& word : grader_command(submitted.run(out)).arguments)
        run += "'" + word + "' ";
    course::Command command;
    command.arguments = {
        "unshare", "--mount", "sh", "-c",
        fmt::format("OUT='{}'; RUN() {{ {}; }}; mount -t tmpfs -o {} none "
                    "\"$OUT\" || exit 99\n{}",
                    out.string(), run, options, script)};
    command.environment = course::plain_environment();
    return says(command);
}

}  // namespace

TEST_CASE(
    "killed at any moment, again and again, it ends with the same grades") {
    if (!has_sandbox()) return;
    constexpr int rounds = 5, kills = 10;
    std::mt19937 random(20);
    std::uniform_int_distribution<int> moment(20, 900);
    for (int round = 0; round < rounds; ++round) {
        const Class submitted;
        const fs::path out = submitted.folder / "out";
        for (int k = 0; k < kills; ++k) {
            const pid_t grader = start(grader_command(submitted.run(out)));
            std::this_thread::sleep_for(milliseconds(moment(random)));
            ::kill(grader, SIGKILL);
            wait_for(grader);
        }
        const Said last = grader_says(submitted.run(out));
        INFO("round " << round << "\n" << last.text);
        CHECK(last.code == 0);
        check_same(out, undisturbed());
        check_no_attempt_twice(out);
    }
    for (int k = 0; k < 100 && sandbox_processes() > 0; ++k)
        std::this_thread::sleep_for(milliseconds(100));
    CHECK(sandbox_processes() == 0);
}

TEST_CASE("one lane and many write the same bytes") {
    if (!has_sandbox()) return;
    const Class submitted;
    for (const int jobs : {1, 5}) {
        const fs::path out = submitted.folder / std::to_string(jobs);
        CHECK(grader_says(submitted.run(out, jobs)).code == 0);
        check_same(out, undisturbed());
    }
}

TEST_CASE(
    "interrupted from the keyboard, it says so and goes on the next time") {
    if (!has_sandbox()) return;
    const Class submitted;
    const fs::path out = submitted.folder / "out";
    const pid_t grader = start(grader_command(submitted.run(out)));
    while (!fs::exists(out / "gradebook.sqlite"))
        std::this_thread::sleep_for(milliseconds(10));
    std::this_thread::sleep_for(milliseconds(200));
    ::kill(grader, SIGINT);
    const int status = wait_for(grader);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) <= 1);
    CHECK(grader_says(submitted.run(out)).code == 0);
    check_same(out, undisturbed());
}

TEST_CASE("a full disk is said, and nothing of before is lost") {
    if (!has_sandbox() || !can_mount()) return;
    const Class submitted;
    const Said said = with_small_disk(
        submitted, "size=200k",
        "RUN; echo \"code $?\"; mount -o remount,size=64m \"$OUT\"\n"
        "RUN; echo \"code $?\"; mkdir \"$OUT.kept\"\n"
        "cp -r \"$OUT\"/. \"$OUT.kept\"");
    INFO(said.text);
    CHECK(contains(said.text, "code 3"));
    CHECK(contains(said.text, "disk is full"));
    CHECK(contains(said.text, "code 0"));
    check_same(submitted.folder / "small.kept", undisturbed());
}

TEST_CASE("a folder that is read-only is said before anything is judged") {
    if (!has_sandbox() || !can_mount()) return;
    const Class submitted;
    const Said said = with_small_disk(
        submitted, "size=64m",
        "RUN; mount -o remount,ro \"$OUT\"\nRUN; echo \"code $?\"\n"
        "mkdir \"$OUT.kept\"; cp -r \"$OUT\"/. \"$OUT.kept\"");
    INFO(said.text);
    CHECK(contains(said.text, "code 3"));
    CHECK(contains(said.text, "gradebook.sqlite"));
    check_same(submitted.folder / "small.kept", undisturbed());
}

TEST_CASE("a gradebook that another program holds for a while is waited for") {
    if (!has_sandbox()) return;
    const Class submitted;
    const fs::path out = submitted.folder / "out";
    const pid_t grader = start(grader_command(submitted.run(out)));
    while (!fs::exists(out / "gradebook.sqlite-wal"))
        std::this_thread::sleep_for(milliseconds(10));
    {
        SQLite::Database book(out / "gradebook.sqlite", SQLite::OPEN_READWRITE,
                              60'000);
        SQLite::Transaction held(book, SQLite::TransactionBehavior::IMMEDIATE);
        std::this_thread::sleep_for(std::chrono::seconds(5));
    }
    const int status = wait_for(grader);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    check_same(out, undisturbed());
}

TEST_CASE("a second grader in the same folder stops at once") {
    if (!has_sandbox()) return;
    const Class submitted;
    const fs::path out = submitted.folder / "out";
    const pid_t first = start(grader_command(submitted.run(out)));
    while (!fs::exists(out / "gradebook.sqlite"))
        std::this_thread::sleep_for(milliseconds(10));
    const Said second = grader_says(submitted.run(out));
    INFO(second.text);
    CHECK(second.code == 2);
    CHECK(contains(second.text, "another grader is at work"));
    const int status = wait_for(first);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    check_same(out, undisturbed());
}

TEST_CASE("what a killed grader left in the temporary folder is removed") {
    if (!has_sandbox()) return;
    const course::TemporaryFolder temporary;
    const auto old = temporary / "course-aaaaaa";
    const auto fresh = temporary / "course-bbbbbb";
    const auto other = temporary / "notes";
    for (const auto& folder : {old, fresh, other}) fs::create_directory(folder);
    const auto an_hour_ago =
        fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const auto& folder : {old, other})
        fs::last_write_time(folder, an_hour_ago);
    fs::permissions(temporary.path(), fs::perms(0711));
    course::Command command = grader_command(
        {"judge", "tip", course::exercise_named("tip").skeleton()});
    command.environment.push_back("TMPDIR=" + temporary.path().string());
    const Said said = says(command);
    INFO(said.text);
    CHECK(said.code == 1);
    CHECK_FALSE(fs::exists(old));
    CHECK(fs::exists(fresh));  // somebody may just be making it
    CHECK(fs::exists(other));
}
