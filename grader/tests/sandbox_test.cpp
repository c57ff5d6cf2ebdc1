// Hostile submissions through the sandbox: each gets its verdict, sees nothing
// of this machine, leaves nothing behind, and the other cases are judged.
#include "grader/sandbox/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "course/runner/catch2.h"
#include "course/runner/compile.h"
#include "course/runner/process.h"

using course::Clock;
using course::ExerciseResult;
using course::Verdict;

namespace fs = std::filesystem;

namespace {

constexpr int slot = 5;

const grader::Stage& the_stage() {
    static const grader::Stage stage;
    return stage;
}

/// ctest runs this program once for each isolation.
grader::Isolation the_isolation() {
    const char* asked = std::getenv("ISOLATION");
    return asked != nullptr && std::string_view(asked) == "landlock"
               ? grader::Isolation::landlock
               : grader::Isolation::bubblewrap;
}

/// Whether submissions can be kept apart on this machine; says so if not.
bool has_sandbox() {
    static const auto reason = grader::why_not(the_stage(), the_isolation());
    if (!reason) return true;
    WARN("skipped, not to be had on this machine: " << *reason);
    return false;
}

const std::string includes =
    "#include \"exercises/01_traversal/face_sides.h\"\n"
    "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n"
    "#include <csignal>\n#include <fcntl.h>\n#include <sys/stat.h>\n"
    "#include <unistd.h>\n";

/// The reference, behind these lines at the start of the function.
std::string right_after(const std::string& lines) {
    return "int face_sides(const HalfEdgeTable& he, int i) {\n" + lines +
           "\n    if (he[i].fi == -1) return 0;\n"
           "    int start = i, sides = 0;\n"
           "    do { ++sides; i = he[i].next; } while (i != start);\n"
           "    return sides;\n}\n";
}

/// Running processes of the lane's own user. Those that have ended and only
/// wait to be collected by the machine's first process do not count.
int processes_of_lane() {
    const int user = the_stage().first_user() + slot;
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::ifstream status(entry.path() / "status");
        std::string word, state;
        int uid = -1;
        while (status >> word) {
            if (word == "State:") status >> state;
            if (word == "Uid:") status >> uid;
        }
        if (uid == user && state != "Z") ++count;
    }
    return count;
}

/// The end of a namespace is not waited for; it comes at once.
void check_nothing_left() {
    if (::geteuid() != 0) return;
    const auto until = Clock::now() + std::chrono::seconds(5);
    while (processes_of_lane() > 0 && Clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(processes_of_lane() == 0);
}

ExerciseResult judged(const std::string& source) {
    const course::TemporaryFolder folder;
    const auto file = folder / "face_sides.cpp";
    std::ofstream(file) << source;
    grader::Sandbox sandbox(the_isolation(), the_stage(), slot);
    const auto start = Clock::now();
    const ExerciseResult result =
        course::judge_submission(sandbox, course::exercise_named("face_sides"),
                                 file, course::JudgeKind::lab, {1});
    CHECK(Clock::now() - start < std::chrono::seconds(80));
    check_nothing_left();
    return result;
}

std::string text_of(const ExerciseResult& result) {
    std::string text = result.message + "\n";
    for (const auto& c : result.cases)
        for (const auto& failure : c.failures)
            text += failure.call + ": " + failure.got + "\n";
    return text;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

void check_accepted(const std::string& source) {
    const ExerciseResult result = judged(source);
    INFO(text_of(result));
    CHECK(name(result.verdict) == "accepted");
    CHECK(result.points() == 4);
}

/// All cases fail like this.
void check_fails(const std::string& source, Verdict expected,
                 const std::string& words) {
    const ExerciseResult result = judged(includes + source);
    INFO(text_of(result));
    CHECK(name(result.verdict) == name(expected));
    CHECK(result.points() == 0);
    CHECK(result.cases.size() == 3);
    CHECK(contains(text_of(result), words));
}

/// The lines are run on the border only: the other case keeps its points.
void check_fails_on_border(const std::string& lines, Verdict expected,
                           const std::string& words) {
    const ExerciseResult result =
        judged(includes + right_after("if (he[i].fi == -1) {" + lines + "}"));
    INFO(text_of(result));
    CHECK(name(result.verdict) == name(expected));
    CHECK(result.points() == 2);
    CHECK(contains(text_of(result), words));
}

void check_forbidden(const std::string& lines) {
    INFO(lines);
    check_fails_on_border(lines, Verdict::forbidden_operation, "not allowed");
}

/// `condition` says that something of the machine is visible.
void check_hidden(const std::string& condition) {
    INFO(condition);
    check_accepted(includes +
                   right_after("    if (" + condition + ") return -9;"));
}

/// A compile step that must not come to its end, and shows no secret.
void check_compile_error(const std::string& source) {
    const ExerciseResult result = judged(includes + source + right_after(""));
    INFO(result.message.substr(0, 2000));
    CHECK(name(result.verdict) == "compile_error");
    CHECK(result.points() == 0);
    CHECK_FALSE(contains(result.message, "root:"));
    CHECK(result.message.size() < 2 * course::most_compiler_output);
}

}  // namespace

TEST_CASE("a right submission is accepted in the sandbox") {
    if (!has_sandbox()) return;
    check_accepted(includes + right_after(""));
}

TEST_CASE("endless loops are ended and the other case is judged") {
    if (!has_sandbox()) return;
    check_fails_on_border("volatile int n = 0; while (true) n = n + 1;",
                          Verdict::time_limit_exceeded, "does not end");
    check_fails_on_border("while (true) i = he[i].next;",
                          Verdict::time_limit_exceeded, "line");
    check_fails_on_border("while (true) sleep(1000);",
                          Verdict::time_limit_exceeded, "does not end");
}

TEST_CASE("an endless loop before the first call is ended") {
    if (!has_sandbox()) return;
    check_fails(
        "struct Hang { Hang() { volatile int n = 0; while (true) n = n "
        "+ 1; } } hang;\n" +
            right_after(""),
        Verdict::time_limit_exceeded, "does not end");
}

TEST_CASE("he[-1] is told with its line") {
    if (!has_sandbox()) return;
    check_fails_on_border("\nreturn he[he[i].fi].vi;", Verdict::run_time_error,
                          "he[-1] does not exist");
}

TEST_CASE("crashes are told apart") {
    if (!has_sandbox()) return;
    check_fails_on_border("int* p = nullptr; return *p;",
                          Verdict::run_time_error, "bad pointer");
    check_fails_on_border("return 1 + face_sides(he, i);",
                          Verdict::run_time_error, "the stack is full");
    check_fails_on_border("abort();", Verdict::run_time_error, "aborted");
    check_fails_on_border("throw 7;", Verdict::run_time_error, "int");
}

TEST_CASE("exit(0) is no answer, in the function or before it") {
    if (!has_sandbox()) return;
    check_fails_on_border("exit(0);", Verdict::run_time_error, "exit(0)");
    check_fails_on_border("_exit(0);", Verdict::run_time_error, "exit(0)");
    check_fails("struct Quit { Quit() { exit(0); } } quit;\n" + right_after(""),
                Verdict::run_time_error, "exit(0)");
}

TEST_CASE("a gigabyte of output is ended") {
    if (!has_sandbox()) return;
    check_fails_on_border("for (int n = 0; n < 1 << 30; ++n) putchar('x');",
                          Verdict::run_time_error, "printed more than");
    check_fails_on_border(
        "static char a[1 << 16]; while (true) write(2, a, sizeof a);",
        Verdict::run_time_error, "printed more than");
}

TEST_CASE("a hundred gigabytes of memory are not there") {
    if (!has_sandbox()) return;
    const std::string words = "more than 512 MiB";
    check_fails_on_border("std::vector<int> v(25'000'000'000); return v[i];",
                          Verdict::memory_limit_exceeded, words);
    check_fails_on_border(
        "while (true) *static_cast<volatile char*>(malloc(1 << 20)) = 1;",
        Verdict::memory_limit_exceeded, words);
}

TEST_CASE("processes and threads are forbidden") {
    if (!has_sandbox()) return;
    check_forbidden("while (true) fork();");
    check_forbidden("execl(\"/worker\", \"/worker\", \"--probe\", nullptr);");
    check_forbidden("system(\"true\");");
    check_fails(
        "#include <thread>\n" + right_after("std::thread([] {}).join();"),
        Verdict::forbidden_operation, "not allowed");
}

TEST_CASE("other processes cannot be reached") {
    if (!has_sandbox()) return;
    const std::string headers =
        "#include <sys/ptrace.h>\n"
        "#include <sys/prctl.h>\n#include <sys/syscall.h>\n";
    const auto forbidden = [&](const std::string& call) {
        INFO(call);
        check_fails(headers + right_after(call), Verdict::forbidden_operation,
                    "not allowed");
    };
    forbidden("kill(-1, SIGKILL);");
    forbidden("kill(getppid(), SIGKILL);");
    forbidden("syscall(SYS_tgkill, getppid(), getppid(), SIGKILL);");
    forbidden("ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);");
    forbidden("setsid();");
}

TEST_CASE("the network is forbidden") {
    if (!has_sandbox()) return;
    check_fails("#include <sys/socket.h>\n" +
                    right_after("socket(AF_INET, SOCK_STREAM, 0);"),
                Verdict::forbidden_operation, "not allowed");
    check_fails("#include <sys/socket.h>\n" +
                    right_after("int fds[2]; socketpair(AF_UNIX, SOCK_STREAM, "
                                "0, fds);"),
                Verdict::forbidden_operation, "not allowed");
}

TEST_CASE("files cannot be written, made, renamed or removed") {
    if (!has_sandbox()) return;
    const fs::path target =
        fs::temp_directory_path() /
        fmt::format("half-edge-sandbox-test-{}", ::getpid());
    const std::string quoted = "\"" + target.string() + "\"";
    check_forbidden("fopen(" + quoted + ", \"w\");");
    check_forbidden("open(" + quoted + ", O_CREAT | O_RDWR, 0666);");
    check_forbidden("open(\"/submission.so\", O_WRONLY);");
    check_forbidden("open(\"/worker\", O_RDONLY | O_TRUNC);");
    check_forbidden("rename(\"/worker\", " + quoted + ");");
    check_forbidden("unlink(\"/submission.so\");");
    check_forbidden("symlink(\"/etc/passwd\", " + quoted + ");");
    CHECK_FALSE(fs::exists(target));
}

TEST_CASE("nothing of this machine can be read") {
    if (!has_sandbox()) return;
    check_hidden("open(\"/etc/passwd\", O_RDONLY) >= 0");
    check_hidden("open(\"/proc/self/environ\", O_RDONLY) >= 0");
    check_hidden("open(\"/proc/1/mem\", O_RDONLY) >= 0");
    check_hidden("open(\"/dev/null\", O_RDONLY) >= 0");
    check_hidden("getuid() == 0");
}

TEST_CASE("not even names and numbers of this machine can be seen") {
    if (!has_sandbox()) return;
    const bool wrapped = the_isolation() == grader::Isolation::bubblewrap;
    if (wrapped) check_hidden("getpid() > 1000");
    // Landlock alone hides contents, not names; root changes the root, too.
    if (!wrapped && ::geteuid() != 0) return;
    check_hidden("access(\"/home\", F_OK) == 0 || access(\"/tmp\", F_OK) == 0");
    const std::string root = course::source_root().string();
    check_hidden("access(\"" + root + "\", F_OK) == 0");
}

TEST_CASE("only the channel is open, and no file is behind it") {
    if (!has_sandbox()) return;
    check_hidden(
        "[] { struct stat s; for (int fd = 4; fd < 128; ++fd)"
        " if (fstat(fd, &s) == 0) return true; return false; }()");
    check_hidden("read(0, &i, 4) > 0");
}

TEST_CASE("who fails on one mesh and passes on smaller ones has failed") {
    if (!has_sandbox()) return;
    const ExerciseResult result =
        judged(includes + right_after("static bool first = true;\n"
                                      "if (he.size() != 16 && first) {\n"
                                      "    first = false;\n    return -1;\n}"));
    INFO(text_of(result));
    CHECK(name(result.verdict) == "wrong_answer");
    CHECK(result.points() == 3);
    REQUIRE(result.cases.size() == 3);
    REQUIRE(result.cases[2].failures.size() == 1);
    CHECK(result.cases[2].failures[0].mesh.name == "generated mesh 0");
}

TEST_CASE("the environment has nothing but the locale and the folder") {
    if (!has_sandbox()) return;
    check_accepted(includes +
                   right_after("for (char** e = environ; *e != nullptr; ++e)\n"
                               "    if (strcmp(*e, \"LC_ALL=C.UTF-8\") != 0 &&"
                               " strcmp(*e, \"PWD=/\") != 0) return -9;"));
}

TEST_CASE("what is written into the channel is no answer") {
    if (!has_sandbox()) return;
    const ExerciseResult result = judged(
        includes +
        right_after("    static char forged[500]; write(3, forged, 500);"));
    INFO(text_of(result));
    CHECK(result.points() == 0);
    CHECK(name(result.verdict) == "run_time_error");
}

TEST_CASE("a channel that is closed ends the case") {
    if (!has_sandbox()) return;
    check_fails(right_after("    close(3);"), Verdict::run_time_error, "");
}

TEST_CASE("limits cannot be lifted and signals do not help") {
    if (!has_sandbox()) return;
    check_fails_on_border(
        "signal(SIGTERM, SIG_IGN); signal(SIGXCPU, SIG_IGN);\n"
        "sigset_t all; sigfillset(&all); sigprocmask(SIG_BLOCK, &all, "
        "nullptr); while (true) {}",
        Verdict::time_limit_exceeded, "does not end");
    check_fails(
        "#include <sys/resource.h>\n" +
            right_after("rlimit more{RLIM_INFINITY, RLIM_INFINITY};\n"
                        "if (setrlimit(RLIMIT_AS, &more) != 0) return -9;"),
        Verdict::wrong_answer, "-9");
}

TEST_CASE("a file of this machine cannot be included") {
    if (!has_sandbox()) return;
    check_compile_error("#include \"/etc/passwd\"\n");
    check_compile_error("%:include \"/etc/passwd\"\n");
    check_compile_error("#include \"/proc/self/environ\"\n");
    const std::string hidden =
        (course::source_root() / "CMakeLists.txt").string();
    check_compile_error("#include \"" + hidden + "\"\n");
    check_compile_error("#if __has_include(\"" + hidden +
                        "\")\n#else\n#error nothing is there\n#endif\n");
}

TEST_CASE("a file of this machine cannot be embedded") {
    if (!has_sandbox()) return;
    check_compile_error("asm(\".incbin \\\"/etc/passwd\\\"\");\n");
}

TEST_CASE("a device without an end cannot be included") {
    if (!has_sandbox()) return;
    check_compile_error("#include </dev/urandom>\n");
    check_compile_error("#include \"/dev/zero\"\n");
}

TEST_CASE("a source that keeps the compiler busy is stopped") {
    if (!has_sandbox()) return;
    check_compile_error(
        "template <int n, int m> struct Bomb {\n"
        "    static constexpr int value =\n"
        "        Bomb<n - 1, 2 * m>::value + Bomb<n - 1, 2 * m + 1>::value;\n"
        "};\n"
        "template <int m> struct Bomb<0, m> { static constexpr int value = m; "
        "};\n"
        "int bomb = Bomb<30, 0>::value;\n");
}

TEST_CASE("an object of a gigabyte is refused") {
    if (!has_sandbox()) return;
    check_compile_error("char big[1 << 30] = {1};\n");
}

TEST_CASE("a flood of compiler messages is kept in part") {
    if (!has_sandbox()) return;
    std::string flood;
    for (int k = 0; k < 2000; ++k) flood += "#warning flood\n";
    const ExerciseResult result = judged(includes + flood + right_after(""));
    CHECK(name(result.verdict) == "accepted");
    CHECK(contains(result.message, "bytes left out"));
    CHECK(result.message.size() < 2 * course::most_compiler_output);
}

TEST_CASE("an own file of a header's name is not taken for the contract") {
    if (!has_sandbox()) return;
    check_compile_error("#include \"face_sides_hidden.h\"\n");
}

TEST_CASE("submissions one after the other do not see each other") {
    if (!has_sandbox()) return;
    check_fails_on_border("fopen(\"/tmp/left\", \"w\");",
                          Verdict::forbidden_operation, "not allowed");
    check_accepted(includes + right_after(""));
}

namespace {

/// The grader's own program, as a user who is not root.
course::Finished judge_as_nobody(const fs::path& file) {
    course::Command command;
    command.arguments = {"setpriv",
                         "--reuid=65534",
                         "--regid=65534",
                         "--clear-groups",
                         "--no-new-privs",
                         "--",
                         course::build_root() / "grader" / "grader",
                         "judge",
                         "face_sides",
                         file};
    command.environment = course::plain_environment();
    return course::run(command, std::chrono::seconds(100), 1 << 20);
}

}  // namespace

TEST_CASE("an ordinary user has the same sandbox as root") {
    if (::geteuid() != 0 || !has_sandbox()) return;
    const course::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0755));
    const auto judge = [&](const std::string& lines) {
        const auto file = folder / "face_sides.cpp";
        std::ofstream(file) << includes << right_after(lines);
        return judge_as_nobody(file);
    };
    const course::Finished right = judge("");
    INFO(right.output);
    if (contains(right.output, "Permission denied") ||
        contains(right.output, "no isolation")) {
        WARN("skipped: the build folder or namespaces are not for all users");
        return;
    }
    CHECK(WEXITSTATUS(right.status) == 0);
    CHECK(contains(right.output, "accepted"));
    const course::Finished forked = judge("while (true) fork();");
    CHECK(WEXITSTATUS(forked.status) == 1);
    CHECK(contains(forked.output, "forbidden operation"));
    const course::Finished reader =
        judge("if (open(\"/etc/passwd\", O_RDONLY) >= 0) return -9;");
    CHECK(WEXITSTATUS(reader.status) == 0);
}
