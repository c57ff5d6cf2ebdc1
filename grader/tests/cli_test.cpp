// The grader's program as it is built: help, usage errors, exit codes, and the
// shape of what `judge --json` prints.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "course/runner/temporary_folder.h"
#include "grader/tests/grader_program.h"

namespace fs = std::filesystem;

using namespace grader::tests;

namespace {

void check_usage_error(const std::vector<std::string>& arguments,
                       const std::string& words) {
    const Said said = grader_says(arguments);
    INFO(said.text);
    CHECK(said.code == 2);
    CHECK(contains(said.text, words));
}

/// `judge face_sides --json` of this source.
Said judge_json(const std::string& source) {
    const course::TemporaryFolder folder;
    const auto file = folder / "any name.cpp";
    std::ofstream(file) << "#include \"exercises/01_traversal/face_sides.h\"\n"
                        << source;
    return grader_says({"judge", "face_sides", file.string(), "--json"});
}

const std::string right =
    "int face_sides(const HalfEdgeTable& he, int i) {\n"
    "    if (he[i].fi == -1) return 0;\n    int start = i, sides = 0;\n"
    "    do { ++sides; i = he[i].next; } while (i != start);\n"
    "    return sides;\n}\n";

/// The object has what the issue lists, with values that fit each other.
void check_shape(const nlohmann::json& object) {
    CHECK(object.at("exercise") == "face_sides");
    double points = 0;
    REQUIRE(object.at("cases").is_array());
    REQUIRE(object.at("cases").size() >= 5);
    for (const auto& c : object.at("cases")) {
        CHECK(c.at("name").is_string());
        CHECK(course::verdict_named(c.at("verdict").get<std::string>()));
        points += c.at("points").get<double>();
    }
    CHECK(object.at("points").get<double>() == Approx(points));
    CHECK(object.at("max").get<double>() == Approx(11));
}

void check_judged(const std::string& source, int code,
                  const std::string& verdict) {
    const Said said = judge_json(source);
    INFO(said.text);
    CHECK(said.code == code);
    const auto object = nlohmann::json::parse(said.text);
    check_shape(object);
    CHECK(object.at("verdict") == verdict);
}

}  // namespace

TEST_CASE("every command has a help that ends with 0") {
    const Said all = grader_says({"--help"});
    CHECK(all.code == 0);
    for (const std::string command :
         {"run", "regrade", "judge", "validate", "show", "history", "diff",
          "override", "export", "plagiarism", "release", "assignment check",
          "doctor"}) {
        std::vector<std::string> words;
        std::istringstream in(command);
        for (std::string word; in >> word;) words.push_back(word);
        CHECK(contains(all.text, words[0]));
        words.emplace_back("--help");
        const Said help = grader_says(words);
        INFO(command);
        CHECK(help.code == 0);
        CHECK(contains(help.text, "Exit code"));
    }
}

TEST_CASE("the help of run and judge names every option of theirs") {
    const std::string run = grader_says({"run", "--help"}).text;
    for (const char* option :
         {"--out", "--assignment", "--jobs", "--only", "--seed"})
        CHECK(contains(run, option));
    CHECK(contains(grader_says({"judge", "--help"}).text, "--json"));
}

TEST_CASE("wrong usage ends with 2 and says what is wrong") {
    check_usage_error({}, "subcommand");
    check_usage_error({"grade"}, "subcommand");
    check_usage_error({"run"}, "required");
    check_usage_error({"run", "data"}, "--out");
    check_usage_error({"judge", "face_sides"}, "file");
    check_usage_error({"judge", "face_sids", "x.cpp"},
                      "did you mean face_sides?");
    check_usage_error({"judge", "face_sides", "none.cpp"},
                      "none.cpp is no file");
    check_usage_error({"judge", "face_sides", "/"}, "is no file");
    check_usage_error({"validate", "no_such_exercise"}, "no exercise");
    check_usage_error({"show"}, "required");
    check_usage_error({"release"}, "a folder for the student's copy");
    check_usage_error({"export"}, "required");
    check_usage_error({"override", "anna", "prev"}, "required");
    check_usage_error({"plagiarism"}, "required");
    check_usage_error({"assignment"}, "subcommand");
    check_usage_error({"diff", "1", "2"}, "--out");
    check_usage_error({"validate", "--jobs", "0"}, "--jobs");
    check_usage_error({"validate", "--jobs", "many"}, "--jobs");
    check_usage_error({"validate", "--seed", "-x"}, "--seed");
}

TEST_CASE("run of a folder that is not there is wrong usage") {
    const course::TemporaryFolder folder;
    check_usage_error(
        {"run", (folder / "none").string(), "--out", (folder / "out").string()},
        "none");
    CHECK_FALSE(fs::exists(folder / "out" / "grades.csv"));
}

TEST_CASE("judge ends with 0 when the file is accepted") {
    if (has_sandbox()) check_judged(right, 0, "accepted");
}

TEST_CASE("judge ends with 1 for each verdict that is not accepted") {
    if (!has_sandbox()) return;
    const std::string head = "int face_sides(const HalfEdgeTable& he, int i) {";
    check_judged(head + "return he[i].vi - 100; }", 1, "wrong_answer");
    check_judged(head + "return he[i - i - 1].vi; }", 1, "run_time_error");
    check_judged(head + "while (true) i = he[i].next; }", 1,
                 "time_limit_exceeded");
    check_judged(head + "return std::vector<int>(1 << 30)[he[i].vi]; }", 1,
                 "memory_limit_exceeded");
    check_judged("#include <unistd.h>\n" + head + "return fork() + he[i].vi; }",
                 1, "forbidden_operation");
    check_judged("int face_sides(", 1, "compile_error");
}

TEST_CASE("the json is one object even when messages are no text") {
    if (!has_sandbox()) return;
    const Said said =
        judge_json("#warning \xff\xfe \"quoted\" \x1b[31m\n" + right);
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(nlohmann::json::parse(said.text).at("verdict") == "accepted");
    CHECK_FALSE(contains(said.text, "\x1b"));
}

TEST_CASE("without --json the verdict is in words") {
    if (!has_sandbox()) return;
    const auto file = course::exercise_named("face_sides").skeleton();
    const Said said = grader_says({"judge", "face_sides", file.string()});
    CHECK(said.code <= 1);
    CHECK(contains(said.text, "face_sides: "));
    CHECK(contains(said.text, " of 11 points"));
}

TEST_CASE("judge of a table that is handed in needs no compiler") {
    if (!has_sandbox()) return;
    const auto file = course::exercise_named("complete_table").skeleton();
    const Said said =
        grader_says({"judge", "complete_table", file.string(), "--json"});
    INFO(said.text);
    CHECK(said.code == 1);
    const auto object = nlohmann::json::parse(said.text);
    CHECK(object.at("exercise") == "complete_table");
    CHECK(object.at("verdict") == "wrong_answer");
}

TEST_CASE("a fault of the grader ends with 3 and is no verdict of the file") {
    course::Command command;
    command.arguments = {
        course::build_root() / "grader" / "grader", "judge", "face_sides",
        course::exercise_named("face_sides").skeleton(), "--json"};
    command.environment = course::plain_environment();
    command.environment.push_back("TMPDIR=/no/such/folder");
    const course::Finished finished =
        course::run(command, std::chrono::seconds(100), std::size_t{1} << 20);
    INFO(finished.output);
    REQUIRE(WIFEXITED(finished.status));
    CHECK(WEXITSTATUS(finished.status) == 3);
    CHECK(contains(finished.output, "grader: "));
    CHECK_FALSE(contains(finished.output, "wrong_answer"));
}

TEST_CASE("doctor tries what this machine protects from, and says so") {
    if (!has_sandbox()) return;
    const Said said = grader_says({"doctor"});
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(contains(said.text, "held    nothing goes over the network"));
    CHECK_FALSE(contains(said.text, "BROKEN"));
    check_usage_error({"doctor", "--isolation", "none"}, "not without");
}

TEST_CASE("without bubblewrap the grader falls back, says so and why") {
    if (!has_sandbox()) return;
    const grader::Stage stage;
    if (grader::why_not(stage, grader::Isolation::landlock)) return;
    // A path with all that the grader itself starts, but no bubblewrap.
    const course::TemporaryFolder programs;
    fs::create_symlink("/usr/bin/ldd", programs / "ldd");
    course::Command command = grader_command(
        {"judge", "face_sides",
         course::source_root() / "solutions/01_traversal/face_sides.cpp"});
    command.environment = {"PATH=" + programs.path().string()};
    const Said said = says(command);
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(contains(said.text, "Isolation is not the strongest: bubblewrap: "));
    command.arguments.insert(command.arguments.end(),
                             {"--isolation", "bubblewrap"});
    CHECK(says(command).code == 2);
}

TEST_CASE("judge works without a sandbox when it is told to") {
    const auto file = course::exercise_named("face_sides").skeleton();
    const Said said = grader_says(
        {"judge", "face_sides", file.string(), "--isolation", "none"});
    INFO(said.text);
    CHECK(said.code <= 1);
    CHECK(contains(said.text, " of 11 points"));
}

TEST_CASE("validate of an exercise that is as it must be ends with 0") {
    if (!has_sandbox()) return;
    const Said said = grader_says({"validate", "face_sides"});
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(contains(said.text, "01_traversal/face_sides"));
    CHECK(contains(said.text, "1 exercises, 0 not as they must be"));
}
