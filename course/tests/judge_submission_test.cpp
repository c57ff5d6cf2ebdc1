// Whole submissions through compiler, worker and judge, as lab runs them: each
// kind of failure gets its verdict and a message that names it, and the other
// cases of the same submission are still judged.
#include "course/runner/judge_submission.h"

#include <fstream>

#include "course/runner/catch2.h"
#include "course/runner/temporary_folder.h"

using namespace course;

namespace {

const std::string include_contract =
    "#include \"exercises/01_traversal/face_sides.h\"\n";

/// What passes the first two cases of the public suite, on the slide mesh, and
/// not the third, on generated ones: students have this file. Behind these
/// lines at the start of the function.
std::string right_after(const std::string& lines) {
    return "int face_sides(const HalfEdgeTable& he, int i) {\n" + lines +
           "\n    const int f = he[i].fi;\n"
           "    return f == -1 ? 0 : f == 1 ? 4 : 3;\n}\n";
}

ExerciseResult judged(const std::string& source) {
    const TemporaryFolder folder;
    const auto file = folder / "face_sides.cpp";
    std::ofstream(file) << include_contract << source;
    LocalWorkplace workplace;
    return judge_submission(workplace, exercise_named("face_sides"), file,
                            JudgeKind::lab, {1});
}

/// The whole first failure of the exercise, and its own message.
std::string text_of(const ExerciseResult& result) {
    std::string text = result.message + "\n";
    for (const CaseResult& c : result.cases)
        for (const Failure& failure : c.failures)
            text += failure.call + ": " + failure.got + "\n";
    return text;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// All cases fail like this, no point is given, the words are said.
void check_fails(const std::string& source, Verdict expected,
                 const std::string& words) {
    const auto start = Clock::now();
    const ExerciseResult result = judged(source);
    INFO(text_of(result));
    CHECK(result.verdict == expected);
    CHECK(result.points() == 0);
    REQUIRE(result.cases.size() == 3);
    for (const CaseResult& c : result.cases) CHECK(c.verdict == expected);
    CHECK(contains(text_of(result), words));
    CHECK(Clock::now() - start < std::chrono::seconds(60));
}

/// The lines go wrong on the border only: the case of the faces keeps its
/// points.
void check_fails_on_border(const std::string& lines, Verdict expected,
                           const std::string& words) {
    const ExerciseResult result =
        judged(right_after("    if (he[i].fi == -1) {" + lines + "}"));
    INFO(text_of(result));
    CHECK(result.verdict == expected);
    CHECK(result.points() == 2);
    REQUIRE(result.cases.size() == 3);
    CHECK(result.cases[0].verdict == Verdict::accepted);
    CHECK(result.cases[1].verdict == expected);
    CHECK(contains(text_of(result), words));
}

}  // namespace

TEST_CASE("limits of exercises are read as they were written") {
    Limits some, none;
    some.call_ms = 77;
    some.source_kib = 1;
    const std::map<std::string, Limits> all = {{"tip", none}, {"prev", some}};
    CHECK((read_limits_file(limits_file(all)) == all));
    CHECK(read_limits_file("tip 1 2 3\nprev one\n\n" + limits_file(all) +
                           "face 1 2 3 4 5 6 7 8 9 10 11 12 13 14\n")
              .size() == 2);
}

TEST_CASE("the limits of the exercise are those of its submission") {
    const TemporaryFolder folder;
    const auto file = folder / "face_sides.cpp";
    std::ofstream(file) << include_contract
                        << "int face_sides(const HalfEdgeTable& he, int i) {\n"
                           "    static volatile char* much =\n"
                           "        new char[256 << 20];\n"
                           "    *much = 1;\n"
                           "    if (he[i].fi == -1) return 0;\n"
                           "    int sides = 0, k = i;\n"
                           "    do ++sides, k = he[k].next; while (k != i);\n"
                           "    return sides;\n"
                           "}\n";
    Exercise exercise = exercise_named("face_sides");
    LocalWorkplace workplace;
    const auto verdict = [&] {
        return judge_submission(workplace, exercise, file, JudgeKind::lab, {1})
            .verdict;
    };
    CHECK(verdict() == Verdict::accepted);
    exercise.limits.memory_mib = 200;
    CHECK(verdict() == Verdict::memory_limit_exceeded);
}

TEST_CASE("a right submission is accepted with all its points") {
    const Exercise exercise = exercise_named("face_sides");
    if (!has_solutions()) return;
    LocalWorkplace workplace;
    const ExerciseResult result = judge_submission(
        workplace, exercise, exercise.solution(), JudgeKind::lab, {1});
    INFO(text_of(result));
    CHECK(result.verdict == Verdict::accepted);
    CHECK(result.points() == 4);
    CHECK(result.max() == 4);
}

/// Uses what is instantiated for submissions in the worker, not in them: each
/// kind of container with all that is said of it there.
const std::string uses_containers = R"(
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>
namespace {
template <class Vector>
int use_vector(Vector v) {
    typename Vector::value_type x{};
    v.push_back(x);
    v.insert(v.begin(), x);
    v.insert(v.end(), v.front());
    v.resize(7);
    v.erase(v.begin(), v.begin() + 2);
    Vector w = v;
    v = std::move(w);
    const Vector& c = v;
    int n = 0;
    for (auto i = c.begin(); i != c.end(); ++i) ++n;
    for (auto i = v.rbegin(); i != v.rend(); ++i) ++n;
    return n;
}
template <class Set>
int use_set(Set s) {
    typename Set::key_type x{};
    s.insert(x);
    s.insert(std::move(x));
    int n = s.count(*s.begin()) > 0 && s.find(*s.begin()) != s.end();
    for (const auto& y : s) n += &y != nullptr;
    const Set t = s;
    s.erase(s.begin());
    return n + static_cast<int>(s.size() + t.size());
}
template <class Map>
int use_map(Map m) {
    typename Map::key_type x{};
    m[x];
    m[std::move(x)] = {};
    int n = 0;
    for (auto& [key, value] : m) n += &value != nullptr && m.count(key) > 0;
    const Map t = m;
    m.erase(m.begin()->first);
    return n + (t.lower_bound(t.begin()->first) == t.begin()) + m.empty();
}
int use_all(std::span<const int> ints, std::span<const Vec3> points) {
    using Two = std::array<int, 2>;
    using Pair = std::pair<int, int>;
    using Ints = std::vector<int>;
    int n = use_vector(Ints{}) + use_vector(std::vector<char>{}) +
            use_vector(std::vector<double>{}) +
            use_vector(std::vector<bool>{}) + use_vector(std::vector<Vec3>{}) +
            use_vector(std::vector<HalfEdge>{}) +
            use_vector(std::vector<Ints>{}) + use_vector(std::vector<Two>{}) +
            use_vector(std::vector<std::array<int, 3>>{}) +
            use_vector(std::vector<Pair>{}) + use_set(std::set<int>{}) +
            use_set(std::set<Pair>{}) + use_set(std::set<Two>{}) +
            use_map(std::map<int, int>{}) + use_map(std::map<int, Ints>{}) +
            use_map(std::map<Pair, int>{}) + use_map(std::map<Pair, Ints>{}) +
            use_map(std::map<Two, int>{});
    for (const int k : ints) n += k;
    for (const Vec3& p : points) n += p.x > 0;
    return n;
}
}
)";

const std::string uses_texts = R"(
#include <string>
int use_texts() {
    const std::string one = "1", half = std::to_string(0.5);
    const std::wstring wide = std::to_wstring(2.0);
    std::vector<std::string> all = {one, half, one + half, "a" + one};
    all.insert(all.begin(), std::string(3, 'x'));
    return std::stoi(one) + static_cast<int>(std::stoul(one)) +
           static_cast<int>(std::stod(half) + std::stof(half)) +
           static_cast<int>(std::stold(wide) + std::stod(wide)) +
           std::stoi(wide) + static_cast<int>(std::stoll(one) + std::stol(one));
}
)";

TEST_CASE("what a submission finds compiled already is there") {
    struct Use {
        std::string source, call;
    };
    const Use use = GENERATE(
        Use{uses_containers, "use_all({}, {}) > 0"},
        Use{uses_containers + uses_texts, "use_all({}, {}) + use_texts() > 0"},
        Use{uses_texts + "#include <charconv>\n#include <sstream>\n",
            "(std::ostringstream() << use_texts()).str() != \"\""},
        Use{uses_texts + "#include <cmath>\n#include <memory>\n",
            "*std::make_unique<int>(1) + std::riemann_zeta(2.0f) > 0"});
    const ExerciseResult result = judged(
        use.source + right_after("    if (!(" + use.call + ")) return -1;\n"));
    INFO(text_of(result));
    CHECK(result.cases.at(0).verdict == Verdict::accepted);
    CHECK(result.cases.at(1).verdict == Verdict::accepted);
}

TEST_CASE("what is right on one mesh only gets the points of that mesh") {
    const ExerciseResult result = judged(right_after(""));
    INFO(text_of(result));
    CHECK(result.verdict == Verdict::wrong_answer);
    CHECK(result.points() == 3);
}

TEST_CASE("a wrong answer says call, expected and got, and asks a question") {
    const ExerciseResult result =
        judged("int face_sides(const HalfEdgeTable&, int) { return 7; }");
    CHECK(result.verdict == Verdict::wrong_answer);
    REQUIRE(result.cases.size() == 3);
    const CaseResult& first = result.cases[0];
    REQUIRE_FALSE(first.failures.empty());
    CHECK(first.failures[0].call == "face_sides(he, 1)");
    CHECK(first.failures[0].expected == "3");
    CHECK(first.failures[0].got == "7");
    CHECK(first.failures[0].mesh.name == "slide");
    CHECK_FALSE(first.hint.empty());
}

TEST_CASE("an endless walk is ended by its reads and says where it walks") {
    check_fails(
        "int face_sides(const HalfEdgeTable& he, int i) {\n"
        "    while (true) i = he[he[i].next].next;\n}\n",
        Verdict::time_limit_exceeded, "line 3");
}

TEST_CASE("an endless loop that reads nothing is ended by its time") {
    check_fails(
        "int face_sides(const HalfEdgeTable&, int) {\n"
        "    volatile int n = 0;\n    while (true) n = n + 1;\n}\n",
        Verdict::time_limit_exceeded, "a loop that does not end");
}

TEST_CASE("an endless loop on the border leaves the other case its points") {
    check_fails_on_border("volatile int n = 0; while (true) n = n + 1;",
                          Verdict::time_limit_exceeded, "does not end");
}

TEST_CASE("he[-1] says index, size, where -1 came from, and the line") {
    check_fails_on_border("\n    return he[he[i].fi].vi;",
                          Verdict::run_time_error,
                          "he[-1] does not exist: the table has 16 "
                          "half-edges, 0..15. -1 is the value of he[0].fi, "
                          "read at line 4");
}

TEST_CASE("the line of he[-1] is that of the student's own file") {
    check_fails(
        "int face_sides(const HalfEdgeTable& he, int) {\n\n\n"
        "    return he[-1].vi;\n}\n",
        Verdict::run_time_error, "line 5");
}

TEST_CASE("a null pointer is a run-time error with the last read") {
    check_fails_on_border("int* p = nullptr; return *p;",
                          Verdict::run_time_error,
                          "segmentation fault: it used a bad pointer");
    check_fails_on_border("int* p = nullptr; return *p;",
                          Verdict::run_time_error, "he[0] at line 3");
}

TEST_CASE("a recursion that does not end is a full stack") {
    check_fails_on_border(
        "volatile int a[64]; a[0] = i;\n"
        "return a[0] + face_sides(he, i);",
        Verdict::run_time_error, "the stack is full");
    check_fails(
        "int deep(int n) { volatile int a[64]; a[0] = n;\n"
        "    return deep(n + 1) + a[0]; }\n"
        "int face_sides(const HalfEdgeTable&, int i) { return deep(i); }\n",
        Verdict::run_time_error, "the stack is full");
}

TEST_CASE("a division by zero is named") {
    check_fails_on_border("volatile int z = 0; return 9 / z;",
                          Verdict::run_time_error, "division by zero");
}

TEST_CASE("an index outside a vector is caught by the library's assertion") {
    check_fails_on_border("std::vector<int> v; return v[3];",
                          Verdict::run_time_error, "assertion");
}

TEST_CASE("exit(0) in the function is no answer") {
    check_fails("#include <cstdlib>\n" + right_after("    std::exit(0);"),
                Verdict::run_time_error, "exit(0)");
    check_fails("#include <unistd.h>\n" + right_after("    _exit(0);"),
                Verdict::run_time_error, "exit(0)");
}

TEST_CASE("exit(0) before the first call is no answer") {
    check_fails(
        "#include <cstdlib>\n"
        "struct Quit { Quit() { std::exit(0); } } quit;\n" +
            right_after(""),
        Verdict::run_time_error, "exit(0)");
}

TEST_CASE("exit(0) on the border leaves the other case its points") {
    check_fails_on_border("__builtin_exit(0);", Verdict::run_time_error,
                          "exit(0)");
}

TEST_CASE("a gigabyte of output is ended and the other case is judged") {
    check_fails_on_border(
        "for (int n = 0; n < 1 << 30; ++n) __builtin_putchar('x');",
        Verdict::run_time_error, "printed more than 2048 KiB");
}

TEST_CASE("a little output does no harm and is kept") {
    const ExerciseResult result =
        judged("#include <cstdio>\n" + right_after("    std::puts(\"here\");"));
    CHECK(result.points() == 3);
    REQUIRE_FALSE(result.cases.empty());
    CHECK(contains(result.cases[0].printed, "here\n"));
}

TEST_CASE("a hundred gigabytes of memory are not there") {
    const std::string words = "more than 512 MiB of memory";
    check_fails_on_border("std::vector<int> v(25'000'000'000); return v[i];",
                          Verdict::memory_limit_exceeded, words);
    // Not filled: on a slow machine that would be a question of time.
    check_fails_on_border(
        "std::vector<int> v; while (true) v.reserve(2 * v.capacity() + 1000);",
        Verdict::memory_limit_exceeded, words);
    check_fails_on_border(
        "while (true) {\n"
        "    void* m = __builtin_malloc(1 << 20);\n"
        "    *static_cast<volatile char*>(m) = 1;\n}",
        Verdict::memory_limit_exceeded, words);
}

TEST_CASE("malloc that gives nothing and is used anyway is a bad pointer") {
    check_fails_on_border(
        "void* m = __builtin_malloc(100'000'000'000);\n"
        "*static_cast<volatile char*>(m) = 1;",
        Verdict::run_time_error, "bad pointer");
}

TEST_CASE("whatever is thrown is a run-time error") {
    check_fails_on_border("throw 7;", Verdict::run_time_error, "int");
    check_fails("#include <stdexcept>\n" +
                    right_after("    throw std::runtime_error(\"oh\");"),
                Verdict::run_time_error, "oh");
}

TEST_CASE("an exception with the judge's own words forges nothing") {
    check_fails("#include <stdexcept>\n" +
                    right_after("    throw std::runtime_error(\"the "
                                "submission's process failed\");"),
                Verdict::run_time_error, "process failed");
}

TEST_CASE("an exception with an endless text is cut") {
    const ExerciseResult result =
        judged("#include <stdexcept>\n#include <string>\n" +
               right_after("    throw std::runtime_error(std::string("
                           "50'000'000, 'x'));"));
    CHECK(result.verdict == Verdict::run_time_error);
    CHECK(text_of(result).size() < 100'000);
}

TEST_CASE("a function without a return is told so by the compiler") {
    const ExerciseResult result =
        judged("int face_sides(const HalfEdgeTable&, int) {}\n");
    CHECK(result.verdict != Verdict::accepted);
    CHECK(result.points() == 0);
    CHECK(contains(result.message, "no return statement"));
}

TEST_CASE("a missing function is a compile error that names it") {
    check_fails("int face_side(const HalfEdgeTable&, int) { return 0; }\n",
                Verdict::compile_error,
                "the file does not define face_sides(HalfEdgeTable const&, "
                "int)");
}

TEST_CASE("a function with another signature is a compile error") {
    check_fails(
        "int face_sides(HalfEdgeTable he, int) { return he.size(); }\n"
        "int face_sides(const HalfEdgeTable&, long) { return 0; }\n",
        Verdict::compile_error, "parameters that face_sides.h");
    check_fails("void face_sides(const HalfEdgeTable&, int) {}\n",
                Verdict::compile_error, "ambiguating");
}

TEST_CASE("what does not compile shows the compiler's words and line") {
    check_fails(
        "int face_sides(const HalfEdgeTable& he, int i) {\n"
        "    return he[i].nxt;\n}\n",
        Verdict::compile_error, "face_sides.cpp:3:");
    check_fails(
        "int face_sides(const HalfEdgeTable& he, int i) {\n"
        "    return he[i].nxt;\n}\n",
        Verdict::compile_error, "nxt");
}

TEST_CASE("the warnings of a file that compiles are kept") {
    const ExerciseResult result =
        judged(right_after("    { int i = 0; (void)i; }"));
    CHECK(result.points() == 3);
    CHECK(contains(result.message, "shadows a parameter"));
}

TEST_CASE("a static vector works, and is new in each case") {
    const ExerciseResult result =
        judged(right_after("    static std::vector<int> calls;\n"
                           "    calls.push_back(i);\n"
                           "    if (calls.size() > 3) return -1;"));
    INFO(text_of(result));
    CHECK(result.points() == 3);
}

namespace {

/// The failures on generated meshes of a function that is right on the slide
/// mesh; on other tables, which have not 16 rows, the lines come first.
CaseResult on_other_meshes(const std::string& lines) {
    const ExerciseResult result = judged(
        right_after("    if (he.size() != 16) {\n" + lines + "\n    }\n"));
    INFO(text_of(result));
    CHECK(result.points() == 3);
    REQUIRE(result.cases.size() == 3);
    REQUIRE(result.cases[2].failures.size() == 1);
    CHECK(contains(result.cases[2].failures[0].note,
                   "found on generated mesh 0 (seed 1)"));
    return result.cases[2];
}

/// The same, and that the failure is shown on a mesh of so many faces.
void check_shrunk(const std::string& lines, Verdict expected, int faces,
                  const std::string& words) {
    const CaseResult result = on_other_meshes(lines);
    CHECK(result.verdict == expected);
    const Failure& failure = result.failures[0];
    INFO(failure.got << "\n" << failure.note);
    CHECK(contains(failure.got, words));
    CHECK(failure.note.ends_with(", shrunk from 19 faces to " +
                                 std::to_string(faces)));
    CHECK(failure.mesh.name == "generated mesh 0, shrunk");
}

/// The same, and that it is shown on the mesh where it was found.
void check_not_shrunk(const std::string& lines, Verdict expected) {
    const CaseResult result = on_other_meshes(lines);
    CHECK(result.verdict == expected);
    CHECK(result.failures[0].mesh.name == "generated mesh 0");
    CHECK_FALSE(contains(result.failures[0].note, "shrunk"));
}

}  // namespace

TEST_CASE("however it fails on a generated mesh, the mesh is made smaller") {
    check_shrunk("return -1;", Verdict::wrong_answer, 1, "-1");
    check_shrunk("return he[-1].vi;", Verdict::run_time_error, 1, "line 4");
    check_shrunk("int* p = nullptr; return *p;", Verdict::run_time_error, 1,
                 "segmentation fault");
    check_shrunk("__builtin_exit(0);", Verdict::run_time_error, 1, "exit(0)");
    check_shrunk("throw 7;", Verdict::run_time_error, 1, "int");
    check_shrunk("while (true) i = he[i].opp;", Verdict::time_limit_exceeded, 1,
                 "line 4");
    check_shrunk("int* p = nullptr; if (he.size() > 30) return *p; return -1;",
                 Verdict::run_time_error, 6, "segmentation fault");
}

TEST_CASE("what takes long is shown where it was found, and not tried again") {
    const auto start = Clock::now();
    check_not_shrunk("volatile int n = 0; while (true) n = n + 1;",
                     Verdict::time_limit_exceeded);
    check_not_shrunk(
        "std::vector<int> v; while (true) v.reserve(2 * v.capacity() + 1000);",
        Verdict::memory_limit_exceeded);
    CHECK(Clock::now() - start < std::chrono::seconds(60));
}

TEST_CASE("an endless loop on smaller meshes only takes no points of others") {
    // Each time that it is tried; four that count would end the judging.
    const CaseResult result = on_other_meshes(
        "volatile int n = 0; while (he.size() < 20) n = n + 1; return -1;");
    CHECK(result.verdict == Verdict::wrong_answer);
    CHECK(contains(result.failures[0].note, "shrunk"));
}

TEST_CASE("an empty file, and one of any bytes, are compile errors") {
    check_fails("", Verdict::compile_error, "does not define face_sides");
    check_fails(std::string("\0\x01\xff{", 4), Verdict::compile_error, "error");
}

TEST_CASE("a file that is not there is a compile error, not a crash") {
    LocalWorkplace workplace;
    const TemporaryFolder folder;
    const ExerciseResult result =
        judge_submission(workplace, exercise_named("face_sides"),
                         folder / "none.cpp", JudgeKind::lab, {1});
    CHECK(result.verdict != Verdict::accepted);
    CHECK(result.points() == 0);
}

TEST_CASE("an exercise that has no judge is a fault of the grader") {
    LocalWorkplace workplace;
    const TemporaryFolder folder;
    std::ofstream(folder / "x.cpp") << "int x;\n";
    const Exercise unknown{"01_traversal", "no_such_exercise", false};
    const ExerciseResult result = judge_submission(
        workplace, unknown, folder / "x.cpp", JudgeKind::lab, {1});
    CHECK(result.verdict == Verdict::grader_fault);
    CHECK_FALSE(result.message.empty());
}
