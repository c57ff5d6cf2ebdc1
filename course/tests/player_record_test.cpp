// Recording walks for real: compiled, run and read back. Expected steps are
// written by hand, and the same for every compiler.
#include "course/player/record.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/player/walk_page.h"
#include "course/runner/catch2.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

using namespace course;

namespace fs = std::filesystem;

namespace {

Recording recorded_with(const std::string& exercise,
                        const RecordOptions& options) {
    const Exercise found = exercise_named(exercise);
    if (can_be_shown(found)) make_ready_to_record({found});
    return record(found, options);
}

/// A student's file of face_sides, with this for its body, and functions before
/// it.
class Written {
public:
    explicit Written(const std::string& body, const std::string& before = "")
        : file_(folder_ / "mine.cpp") {
        std::ofstream(file_) << "#include <stdexcept>\n"
                                "#include "
                                "\"exercises/01_traversal/face_sides.h\"\n"
                             << before
                             << "int face_sides(const HalfEdgeTable& he, int "
                                "i) {\n"
                             << body << "}\n";
    }

    /// The walk from a half-edge, of the last source.
    RecordedWalk walk(int start, bool locals = false,
                      const std::string& compiler = "") const {
        RecordOptions options;
        options.starts = {start};
        options.locals = locals;
        options.compiler = compiler;
        return recording(options).walks.back();
    }
    Recording recording(std::optional<int> start, bool locals = false) const {
        RecordOptions options;
        if (start) options.starts = {*start};
        options.locals = locals;
        return recording(options);
    }
    Recording recording(RecordOptions options) const {
        options.file = file_;
        return recorded_with("face_sides", options);
    }

private:
    TemporaryFolder folder_;
    fs::path file_;
};

Recording recorded(const std::string& exercise, bool locals = false,
                   const std::string& compiler = "") {
    RecordOptions options;
    options.locals = locals;
    options.compiler = compiler;
    return recorded_with(exercise, options);
}

/// "12: he[4].next = 7", "12: he[5].opp = 9 (3)", "12" and what changed.
std::string text_of(const Step& step) {
    constexpr const char* fields[] = {"vi", "fi", "next", "opp"};
    std::string text = fmt::format("{}", step.line);
    if (step.i >= 0) text += fmt::format(": he[{}]", step.i);
    if (step.field >= 0)
        text += fmt::format(".{} = {}", fields[step.field], step.value);
    if (step.before) text += fmt::format(" ({})", *step.before);
    if (step.added) text += " new";
    for (const auto& [name, value] : step.locals)
        text += fmt::format(" {}={}", name, value);
    return step.function.empty() ? text : step.function + " " + text;
}

std::vector<std::string> texts_of(const RecordedWalk& walk) {
    std::vector<std::string> texts;
    for (const Step& step : walk.steps) texts.push_back(text_of(step));
    return texts;
}

/// What is read and written alone, as it is without gdb.
std::vector<std::string> uses_of(const RecordedWalk& walk) {
    std::vector<std::string> texts;
    for (Step step : walk.steps) {
        if (step.i < 0) continue;
        step.locals.clear();
        step.function.clear();
        texts.push_back(text_of(step));
    }
    return texts;
}

/// The values that a variable is seen to get, one after the other.
std::vector<std::string> values_of(const RecordedWalk& walk,
                                   const std::string& variable) {
    std::vector<std::string> values;
    for (const Step& step : walk.steps)
        for (const auto& [name, value] : step.locals)
            if (name == variable && value != "null") values.push_back(value);
    return values;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The table after all steps; fails where a step does not fit the one before.
std::vector<Row> replayed(const Recording& recording,
                          const RecordedWalk& walk) {
    std::vector<Row> rows = walk.table ? *walk.table : recording.table;
    for (const Step& step : walk.steps) {
        const auto i = static_cast<std::size_t>(step.i);
        const auto field = static_cast<std::size_t>(step.field);
        if (step.added) {
            REQUIRE(i == rows.size());
            rows.push_back(*step.added);
        } else if (step.cut) {
            rows.resize(static_cast<std::size_t>(*step.cut));
        } else if (step.field >= 0 && !step.in_original) {
            REQUIRE(i < rows.size());
            CHECK(rows[i][field] == step.before.value_or(step.value));
            rows[i][field] = step.value;
        }
    }
    return rows;
}

std::string json_of(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& r : rows)
        text += fmt::format("{}[{},{},{},{}]", text.empty() ? "" : ",", r[0],
                            r[1], r[2], r[3]);
    return "[" + text + "]";
}

bool has_program(const std::string& name) {
    try {
        return run({{name, "--version"}, plain_environment(), {}},
                   std::chrono::seconds(20), 100)
                   .status == 0;
    } catch (const std::exception&) {
        return false;
    }
}

/// Then local variables are not recorded, and not tested.
bool no_gdb() {
    static const bool none = !recorded("tip", true).notes.empty();
    if (none) WARN("there is no gdb that can be used");
    return none;
}

const std::string good_body =
    "    int start = i, sides = 0;\n"      // 4
    "    if (he[i].fi == -1) return 0;\n"  // 5
    "    do {\n"
    "        ++sides;\n"         // 7
    "        i = he[i].next;\n"  // 8
    "    } while (i != start);\n"
    "    return sides;\n";  // 10

}  // namespace

TEST_CASE("a walk is its reads, in order, with line, column and value") {
    const Recording recording = Written(good_body).recording(std::nullopt);
    REQUIRE(recording.sources.size() == 2);
    REQUIRE(recording.walks.size() == 32);
    CHECK(recording.start_kind == "half-edge");
    CHECK(recording.sources[1].first == 3);
    const RecordedWalk& walk = recording.walks[16 + 4];
    CHECK(walk.call == "face_sides(he, 4)");
    CHECK(walk.start == 4);
    CHECK(walk.result == "4");
    CHECK(walk.expected == "4");
    CHECK(texts_of(walk) ==
          std::vector<std::string>{"5: he[4].fi = 1", "8: he[4].next = 11",
                                   "8: he[11].next = 15", "8: he[15].next = 12",
                                   "8: he[12].next = 4"});
    CHECK(walk.steps[1].from == 13);
    CHECK(walk.steps[1].to == 23);
}

TEST_CASE("lines and local variables fit in between") {
    if (no_gdb()) return;
    const RecordedWalk walk = Written(good_body).walk(1, true);
    CHECK(texts_of(walk) ==
          std::vector<std::string>{"4 i=1 sides=0 start=1", "5: he[1].fi = 0",
                                   "7 sides=1", "8: he[1].next = 3 i=3", "9",
                                   "7 sides=2", "8: he[3].next = 5 i=5", "9",
                                   "7 sides=3", "8: he[5].next = 1 i=1", "9",
                                   "10"});
    const RecordedWalk star = recorded("vertex_star", true).walks[4];
    const auto texts = texts_of(star);
    CHECK(std::count_if(texts.begin(), texts.end(), [](const auto& text) {
              return contains(text, "star=[2,0]") ||
                     contains(text, "star=[2, 0]");
          }) == 1);
}

TEST_CASE("a variable is shown from when it has a value") {
    if (no_gdb()) return;
    const Written file(
        "    int sum = 0;\n"
        "    for (int round = 0; round < 2; ++round) {\n"
        "        int a = he[i].vi, b = he[a].next, c;\n"
        "        c = a + b;\n"
        "        bool found, large = c > 100;\n"
        "        found = true;\n"
        "        char mark;\n"
        "        mark = 'x';\n"
        "        std::array<int, 2> two;\n"
        "        two[1] = c;\n"
        "        struct Walker { const HalfEdgeTable& he; int at; };\n"
        "        const Walker walker{he, a};\n"
        "        for (int j = he[i].next, k = he[j].next,\n"
        "                 m = k > 3 ? j : k;\n"
        "             j == 11; ++j)\n"
        "            sum += m;\n"
        "        sum += (found && large) || mark == 'y' ? 1 : two[1];\n"
        "    }\n"
        "    return sum;\n");
    const std::string compiler = GENERATE("g++", "clang++");
    if (!has_program(compiler)) return;
    const RecordedWalk walk = file.walk(4, true, compiler);
    const auto twice = [](const std::string& value) {
        return std::vector<std::string>{value, value};
    };
    CHECK(values_of(walk, "a") == twice("1"));
    CHECK(values_of(walk, "b") == twice("3"));
    CHECK(values_of(walk, "c") == twice("4"));
    CHECK(values_of(walk, "found") == twice("true"));
    CHECK(values_of(walk, "large") == twice("false"));
    CHECK(values_of(walk, "mark") == twice("120"));
    CHECK(values_of(walk, "two") == twice("[\"?\", 4]"));
    CHECK(values_of(walk, "walker") == twice("\"{at 1}\""));
    CHECK(values_of(walk, "k") == twice("15"));
    CHECK(values_of(walk, "m") == twice("11"));
    CHECK(values_of(walk, "j") ==
          std::vector<std::string>{"11", "12", "11", "12"});
    CHECK(values_of(walk, "sum") ==
          std::vector<std::string>{"0", "11", "15", "26", "30"});
}

TEST_CASE("a shadowed variable is told from the one that it hides") {
    if (no_gdb()) return;
    const RecordedWalk walk = Written(
                                  "    int sides = 0, start = i;\n"
                                  "    do {\n"
                                  "        ++sides;\n"
                                  "        int i = he[start].next;\n"  // 7
                                  "        if (i == 0) break;\n"
                                  "    } while (i != start);\n"
                                  "    return sides;\n")
                                  .walk(4, true);
    const auto texts = texts_of(walk);
    CHECK(std::count(texts.begin(), texts.end(),
                     "7: he[4].next = 11 i (line 7)=11") == 1);
}

TEST_CASE("what the last line of a block does to its variables is shown") {
    if (no_gdb()) return;
    const RecordedWalk walk = Written(
                                  "    int start = i;\n"
                                  "    do {\n"
                                  "        int i = he[start].opp;\n"  // 6
                                  "        i = he[i].next;\n"
                                  "    } while (i != start);\n"
                                  "    return i;\n")
                                  .walk(4, true);
    // Where the block ends then, compilers see in different ways.
    auto texts = texts_of(walk);
    REQUIRE(texts.size() == 5);
    texts.resize(3);
    CHECK(texts == std::vector<std::string>{"4 i=4 start=4",
                                            "6: he[4].opp = 3 i (line 6)=3",
                                            "7: he[3].next = 5 i (line 6)=5"});
}

TEST_CASE("variables are those of the call that a step belongs to") {
    if (no_gdb()) return;
    const Written file(
        "    int a = next_of(he, i), b = he[next_of(he, a)].next;\n"  // 11
        "    advance(he, i);\n"
        "    return a + b + i;\n",
        "int next_of(const HalfEdgeTable& he, int i) {\n"
        "    int n = he[i].next;\n"  // 4
        "    return n;\n"
        "}\n"
        "void advance(const HalfEdgeTable& he, int& i) {\n"
        "    i = he[i].next;\n"  // 8
        "}\n");
    const std::string compiler = GENERATE("g++", "clang++");
    if (!has_program(compiler)) return;
    const RecordedWalk walk = file.walk(4, true, compiler);
    CHECK(texts_of(walk) == std::vector<std::string>{
                                "11 i=4", "next_of 4: he[4].next = 11 i=4 n=11",
                                "5", "4: he[11].next = 15 i=11 n=15", "5",
                                "face_sides 11: he[15].next = 12 a=11 b=12",
                                "12", "advance 8: he[4].next = 11 i=11",
                                "face_sides 12 i=11", "13"});
    std::vector<int> depths;
    for (const Step& step : walk.steps)
        if (step.depth) depths.push_back(*step.depth);
    CHECK(depths == std::vector<int>{1, 0, 1, 0});
}

TEST_CASE("each call of a function that calls itself has its variables") {
    if (no_gdb()) return;
    const RecordedWalk walk = Written(
                                  "    if (he[i].next == 4) return 1;\n"
                                  "    return face_sides(he, he[i].next) +\n"
                                  "           (he[i].vi >= 0 ? 1 : 0);\n")
                                  .walk(4, true);
    CHECK(walk.result == "4");
    std::vector<std::string> i_of_calls(1);
    std::vector<int> depths;
    for (const Step& step : walk.steps) {
        if (step.depth)
            i_of_calls.resize(static_cast<std::size_t>(*step.depth) + 1);
        for (const auto& [name, value] : step.locals)
            if (name == "i") i_of_calls.back() = value;
        if (step.i < 0) continue;
        CHECK(i_of_calls.back() == std::to_string(step.i));
        depths.push_back(static_cast<int>(i_of_calls.size()) - 1);
    }
    CHECK(depths == std::vector<int>{0, 0, 1, 1, 2, 2, 3, 2, 1, 0});
}

TEST_CASE("where lines are no longer recorded, the walk is cut") {
    if (no_gdb()) return;
    const RecordedWalk walk =
        Written("    for (;;) i = he[i].next;\n").walk(4, true);
    int i = 0;
    for (const Step& step : walk.steps) {
        for (const auto& [name, value] : step.locals)
            if (name == "i") i = std::stoi(value);
        if (&step != &walk.steps.back()) CHECK(i == step.value);
    }
    CHECK(walk.steps.size() > 100);
    CHECK(walk.steps.size() + walk.skipped > 100'000);
}

TEST_CASE("helper functions are named, and calls that return are") {
    if (no_gdb()) return;
    const Recording recording = recorded("flip_edge", true);
    const auto edited =
        std::find_if(recording.walks.begin(), recording.walks.end(),
                     [](const RecordedWalk& w) { return !w.result.empty(); });
    REQUIRE(edited != recording.walks.end());
    std::vector<std::string> functions;
    for (const Step& step : edited->steps)
        if (!step.function.empty()) functions.push_back(step.function);
    CHECK(functions == std::vector<std::string>{"along_triangle", "flip_edge",
                                                "joined", "flip_edge"});
}

TEST_CASE("the same is read with and without local variables") {
    for (const std::string exercise : {"vertex_star", "flip_edge"}) {
        const Recording with = recorded(exercise, true);
        const Recording without = recorded(exercise);
        REQUIRE(with.walks.size() == without.walks.size());
        for (std::size_t k = 0; k < with.walks.size(); ++k)
            CHECK(uses_of(with.walks[k]) == uses_of(without.walks[k]));
    }
}

TEST_CASE("clang's trace is that of g++") {
    if (!has_program("clang++") || !has_program("g++")) {
        WARN("g++ and clang++ are not both here: not compared");
        return;
    }
    for (const std::string exercise : {"vertex_star", "with_dangling_edge"})
        CHECK(to_json(recorded(exercise, false, "clang++")) ==
              to_json(recorded(exercise, false, "g++")));
}

TEST_CASE("the steps of an edit lead from the table to the result") {
    for (const std::string exercise :
         {"flip_edge", "collapse", "with_dangling_edge", "build_closed",
          "build"}) {
        INFO(exercise);
        const Recording recording = recorded(exercise);
        int results = 0;
        for (const RecordedWalk& walk : recording.walks) {
            if (walk.result.empty()) continue;
            ++results;
            CHECK(json_of(replayed(recording, walk)) == walk.result);
        }
        CHECK(results > 0);
    }
}

TEST_CASE("of several tables the one that was written last is shown") {
    const Written file(
        "    HalfEdgeTable edited = he;\n"
        "    edited[0].vi = 7;\n"
        "    HalfEdgeTable kept = edited;\n"
        "    int k = kept[0].vi;\n"
        "    edited[2].vi = 9;\n"  // 8
        "    return k + he[0].vi + he[1].vi;\n");
    const Recording recording = file.recording(4);
    const RecordedWalk& walk = recording.walks.back();
    const std::vector<Row> rows = replayed(recording, walk);
    CHECK(rows[0][0] == 7);
    CHECK(rows[2][0] == 9);
    REQUIRE(walk.steps.size() == 5);
    CHECK(texts_of(walk)[3] == "9: he[0].vi = 2");
    CHECK(walk.steps[3].in_original);
    CHECK_FALSE(walk.steps[4].in_original);
}

TEST_CASE("an endless walk is recorded up to its budget, in a small page") {
    const Recording recording =
        Written(
            "    int sides = 0;\n"
            "    for (;;) { ++sides; i = he[i].next; }\n"
            "    return sides;\n")
            .recording(std::nullopt, true);
    const RecordedWalk& walk = recording.walks.back();
    CHECK(contains(walk.error, "the walk does not end"));
    CHECK(walk.result.empty());
    CHECK(walk.expected == "4");
    CHECK(walk.steps.size() >= 40);
    CHECK(walk.skipped > 90'000);
    CHECK(to_json(recording).size() < 100'000);
    CHECK(texts_of(Written("    for (;;) i = he[i].next;\n").walk(3)).size() ==
          400);
}

TEST_CASE("the page of deep recursions from all starts is below 200 kB") {
    const Recording recording =
        Written("    return 1 + face_sides(he, he[i].next);\n")
            .recording(std::nullopt, true);
    CHECK(recording.walks.back().steps.size() >= 40);
    CHECK(walk_page(recording).size() < 200'000);
}

TEST_CASE("the size of a large mesh takes no steps from its walks") {
    RecordOptions options;
    const IndexedMesh mesh = torus(20, 60);
    options.mesh = Fixture{"torus", mesh, build(mesh)};
    options.starts = {0, 1, 2, 3};
    const Recording recording =
        Written("    for (;;) i = he[i].next;\n").recording(options);
    CHECK(to_json(recording).size() > 150'000);
    CHECK(page_json(recording).size() < 100'000);
    CHECK(recording.walks.back().steps.size() == 400);
}

TEST_CASE("what does not exist ends the walk with the checker's message") {
    const RecordedWalk walk =
        Written("    return he[he[i].fi].next;\n").walk(2);
    CHECK(texts_of(walk) == std::vector<std::string>{"4: he[2].fi = -1"});
    CHECK(contains(walk.error, "he[-1] does not exist"));
    CHECK(contains(walk.error, "on the border"));
}

TEST_CASE("exceptions, crashes and endless loops keep what came before") {
    struct Bad {
        std::string body, words;
    };
    const std::string begin = "    int k = he[i].next;\n";
    const std::vector<Bad> all = {
        {"    throw std::runtime_error(\"no idea\");\n",
         "throws std::runtime_error: no idea"},
        {"    throw k;\n", "throws int"},
        {"    int* p = nullptr;\n    *p = k;\n", "segmentation fault"},
        {"    return std::vector<int>{}[1];\n", "assertion of the library"},
        {"    return k + face_sides(he, k);\n", "the stack is full"},
        {"    for (volatile int j = 0;; j = k) {}\n", "a loop does not end"},
        {"    std::vector<int> v(1000000000);\n    return v[7];\n", "memory"},
    };
    for (const Bad& bad : all) {
        INFO(bad.body);
        // A budget of reads would end the recursion first.
        const bool recursion = contains(bad.body, "face_sides");
        const RecordedWalk walk =
            Written(begin + bad.body + "    return k;\n").walk(4);
        INFO(walk.error);
        CHECK((contains(walk.error, bad.words) ||
               (recursion && contains(walk.error, "does not end"))));
        REQUIRE_FALSE(walk.steps.empty());
        CHECK(text_of(walk.steps[0]) == "4: he[4].next = 11");
    }
}

TEST_CASE("a call that ends the whole program costs no other call") {
    const Recording recording = Written(
                                    "    if (i == 3) __builtin_exit(0);\n"
                                    "    return he[i].next;\n")
                                    .recording(std::nullopt);
    CHECK(contains(recording.walks[16 + 3].error, "ended the whole program"));
    CHECK(recording.walks[16 + 2].result == "6");
    CHECK(recording.walks[16 + 4].result == "11");
    CHECK(recording.walks[16 + 15].result == "12");
}

TEST_CASE("what is printed stays out of the recording") {
    const RecordedWalk walk = Written(
                                  "    for (int k = 0; k < 300000; ++k)\n"
                                  "        __builtin_puts(\"much output\");\n"
                                  "    return he[i].next;\n")
                                  .walk(4);
    CHECK(walk.result == "11");
}

TEST_CASE("a file that is none is refused with the compiler's words") {
    CHECK_THROWS_AS(Written("    return he[i].next\n").walk(4), DoesNotCompile);
    try {
        Written("    return 0;\n}\nint other(int i) {\n    return i;\n")
            .walk(4);
        Written("    return he[i].nex;\n").walk(4);
        FAIL("it is taken");
    } catch (const DoesNotCompile& error) {
        CHECK(contains(error.what(), "mine.cpp:4"));
        CHECK_FALSE(contains(error.what(), "traced_table"));
    }
}

TEST_CASE("an exercise without a table says which have one") {
    CHECK_FALSE(can_be_shown(exercise_named("area_vector")));
    try {
        recorded("area_vector");
        FAIL("it is shown");
    } catch (const CannotShow& error) {
        CHECK(contains(error.what(), "works without a half-edge table"));
        CHECK(contains(error.what(), "01_traversal: "));
        CHECK(contains(error.what(), "flip_edge"));
    }
    RecordOptions options;
    options.starts = {16};
    CHECK_THROWS_AS(recorded_with("face_sides", options), CannotShow);
}

TEST_CASE("a mesh of one's own is walked, from vertices where it is asked") {
    RecordOptions options;
    options.locals = false;
    options.mesh = zoo::cube();
    const Recording recording = recorded_with("outgoing", options);
    CHECK(recording.start_kind == "vertex");
    CHECK(recording.mesh_name == "cube");
    REQUIRE(recording.walks.size() == 8);
    for (const RecordedWalk& walk : recording.walks)
        CHECK(walk.steps.size() == 6);
}
