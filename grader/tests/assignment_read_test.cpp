// Assignment files: what they say, and every mistake in them.
#include <algorithm>

#include "course/runner/temporary_folder.h"
#include "grader/pipeline/assignment.h"
#include "grader/tests/golden.h"

using namespace grader;
using namespace grader::tests;

namespace {

const std::vector<std::string> known = {
    "00_table/edge_vertices", "01_traversal/face_sides",
    "01_traversal/vertex_star", "02_border/boundary_walk"};

Assignment read(const std::string& text) {
    const course::TemporaryFolder folder;
    const auto file = folder / "week_1.toml";
    std::ofstream(file, std::ios::binary) << text;
    return read_assignment(file, known);
}

std::vector<AssignmentMistake> mistakes(const std::string& text) {
    try {
        read(text);
    } catch (const AssignmentError& error) {
        return error.mistakes;
    }
    return {};
}

std::string message(const std::string& text) {
    try {
        read(text);
    } catch (const AssignmentError& error) {
        return error.what();
    }
    return "no mistake";
}

}  // namespace

TEST_CASE("exercises keep the order of the file, with their weights") {
    const Assignment assignment = read(
        "name = 'Week 1'\n"
        "hidden_feedback = 'full'\n"
        "[exercises]\n"
        "vertex_star = 2.5\n"
        "\"00_table/edge_vertices\" = 1\n"
        "boundary_walk = 1_000 # the most\n");
    const Assignment expected = {"Week 1",
                                 {{"01_traversal/vertex_star", 2.5, false},
                                  {"00_table/edge_vertices", 1, false},
                                  {"02_border/boundary_walk", 1000, false}},
                                 {FeedbackLevel::full, FeedbackLevel::full},
                                 {},
                                 0};
    CHECK((assignment == expected));
}

TEST_CASE("what a file leaves out has a sensible value") {
    const Assignment assignment = read("[exercises]\nface_sides = 1\n");
    CHECK(assignment.name == "week_1");
    CHECK((assignment.hidden_feedback == HiddenFeedback()));
    CHECK_FALSE(assignment.due.has_value());
}

TEST_CASE("without a file every exercise counts once") {
    const Assignment assignment = default_assignment(known);
    REQUIRE(assignment.exercises.size() == 4);
    CHECK(assignment.exercises[1].exercise == "01_traversal/face_sides");
    CHECK(assignment.exercises[1].weight == 1);
}

TEST_CASE("all mistakes are reported, in the order of the file") {
    const std::string text =
        "nmae = 'Week 1'\n"
        "hidden_feedback = 'ful'\n"
        "  [exercises]\n"
        "face_side = 1\n"
        "vertex_star = 'two'\n"
        "boundary_walk = 0\n"
        "face_sides = 1\n"
        "\"01_traversal/face_sides\" = 1\n"
        "zzz = true\n";
    const std::vector<AssignmentMistake> expected = {
        {1, 1,
         "'nmae' is not a key; expected one of name, exercises, bonus, "
         "hidden_feedback, due, time_zone, late, limits, rounding, teams; did "
         "you mean name?"},
        {2, 19,
         "hidden_feedback is the text 'ful'; expected \"names\", "
         "\"names_and_hints\", \"full\"; did you mean full?"},
        {4, 1,
         "'face_side' is not an exercise; expected one of the 4 there are; "
         "did you mean face_sides?"},
        {5, 15,
         "the weight is the text 'two'; expected a number above 0 and at most "
         "1000"},
        {6, 17, "the weight is 0; expected a number above 0 and at most 1000"},
        {8, 1,
         "01_traversal/face_sides is named a second time; expected each "
         "exercise once"},
        {9, 1, "'zzz' is not an exercise; expected one of the 4 there are"},
        {9, 7,
         "the weight is true; expected a number above 0 and at most 1000"},
    };
    const auto found = mistakes(text);
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(found[k].line == expected[k].line);
        CHECK(found[k].column == expected[k].column);
        CHECK(found[k].what == expected[k].what);
    }
    CHECK_THAT(message(text),
               Containing("week_1.toml:4:1: 'face_side' is not"));
}

TEST_CASE("due dates, late work, bonus, rounding and teams") {
    const Assignment assignment = read(
        "due = 2026-12-11T23:59:00\n"
        "time_zone = 'Europe/Rome'\n"
        "rounding = 0.5\n"
        "teams = true\n"
        "[hidden_feedback]\n"
        "before_due = 'names'\n"
        "after_due = 'full'\n"
        "[late]\n"
        "policy = 'percent_per_day'\n"
        "percent_per_day = 12.5\n"
        "grace_minutes = 10\n"
        "free_days = 2\n"
        "last_day = 7\n"
        "[exercises]\n"
        "face_sides = 1\n"
        "[bonus]\n"
        "vertex_star = 2\n");
    REQUIRE(assignment.due.has_value());
    CHECK(text_of(assignment.due->at) == "2026-12-11T22:59:00Z");
    CHECK(assignment.due->zone == "Europe/Rome");
    CHECK((assignment.late ==
           LatePolicy{LatePolicy::Kind::percent_per_day, 12.5, 10, 2, 7}));
    CHECK(assignment.rounding == 0.5);
    CHECK(assignment.in_teams);
    REQUIRE(assignment.exercises.size() == 2);
    CHECK_FALSE(assignment.exercises[0].is_bonus);
    CHECK(assignment.exercises[1].is_bonus);
    const Instant due = assignment.due->at;
    CHECK((hidden_feedback_at(assignment, due) == FeedbackLevel::names));
    CHECK((hidden_feedback_at(assignment, due + std::chrono::seconds(1)) ==
           FeedbackLevel::full));
}

TEST_CASE("mistakes in dates and in what is late") {
    const std::string end = "[exercises]\nface_sides = 1\n";
    const std::vector<std::pair<std::string, std::string>> rows = {
        {"due = '11 December'\n",
         ":1:7: due is the text '11 December'; expected "
         "a local date and time"},
        {"due = 2026-12-11\n", ":1:7: due is a date or a time; expected"},
        {"due = 2026-12-11T23:59:00Z\n", ":1:7: due is a date or a time;"},
        {"due = 2026-03-29T02:30:00\ntime_zone = 'Europe/Rome'\n",
         ":1:7: 2026-03-29T02:30:00 does not exist in Europe/Rome"},
        {"time_zone = 'Europe/Rom'\n",
         ":1:13: there is no time zone 'Europe/Rom'; expected one such as"},
        {"time_zone = 1\n", ":1:13: time_zone is 1; expected a name"},
        {"late = 'none'\n", ":1:8: late is the text 'none'; expected a table"},
        {"[late]\npolicy = 'none'\n", ":1:1: [late] stands without a due date"},
        {"due = 2026-12-11T23:59:00\n[late]\ngrace_minutes = 1\n",
         ":2:1: [late] has no policy; expected one of none"},
        {"due = 2026-12-11T23:59:00\n[late]\npolicy = 'percent'\n",
         "policy is the text 'percent'; expected \"none\", "
         "\"percent_per_day\", \"refuse\""},
        {"due = 2026-12-11T23:59:00\n[late]\npolicy = 'percent_per_day'\n",
         ":2:1: [late] has no percent_per_day; expected how many"},
        {"due = 2026-12-11T23:59:00\n[late]\npolicy = 'refuse'\n"
         "percent_per_day = 5\n",
         ":2:1: [late] has percent_per_day; expected it with"},
        {"due = 2026-12-11T23:59:00\n[late]\npolicy = 'none'\nlate_days = 3\n",
         ":4:1: 'late_days' is not a key of [late]; expected one of policy, "
         "percent_per_day, grace_minutes, free_days, last_day"},
        {"due = 2026-12-11T23:59:00\n[late]\npolicy = 'none'\nlast_day = 0\n",
         ":4:12: last_day is 0; expected a whole number from 1 to 365"},
        {"rounding = -1\n", ":1:12: rounding is -1; expected a number above 0"},
        {"teams = 'yes'\n", ":1:9: teams is the text 'yes'; expected true"},
        {"[hidden_feedback]\nafter = 'full'\n",
         ":2:1: 'after' is not a key of [hidden_feedback]; expected one of "
         "before_due, after_due"},
        {"[bonus]\nface_sides = 1\n", "named a second time"},
        {"[bonus]\n", ":1:1: [bonus] is empty; expected at least one"},
    };
    for (const auto& [text, expected] : rows)
        CHECK_THAT(message(text + end), Containing(expected));
}

TEST_CASE("limits hold for all exercises, and those of one go on from them") {
    const Assignment assignment = read(
        "[exercises]\nface_sides = 1\nvertex_star = 1\n"
        "[limits]\ncase_seconds = 10\nmemory_mib = 1024\n"
        "[limits.vertex_star]\ncall_seconds = 2.5\ncpu_seconds = 1\n"
        "all_seconds = 60\n");
    course::Limits all;
    all.case_ms = 10'000;
    all.cpu_seconds = 8;
    all.memory_mib = 1024;
    CHECK((assignment.exercises.at(0).limits == all));
    course::Limits own = all;
    own.call_ms = 2500;
    own.later_call_ms = 250;
    own.cpu_ms = 1000;
    own.later_cpu_ms = 400;
    own.run_ms = 60'000;
    CHECK((assignment.exercises.at(1).limits == own));
    const auto shared = limits_of(assignment);
    REQUIRE(shared.size() == 2);
    CHECK(shared[1].exercises == std::vector<std::string>{"vertex_star"});
}

TEST_CASE(
    "the usual limits may be written down, and are still the usual ones") {
    const Assignment assignment = read(
        "[exercises]\nface_sides = 1\nvertex_star = 1\n"
        "[limits]\ncall_seconds = 2\ncpu_seconds = 0.25\ncase_seconds = 5\n"
        "all_seconds = 20\nmemory_mib = 512\n");
    CHECK((assignment.exercises.at(0).limits == course::Limits()));
    CHECK(limits_of(assignment).size() == 1);
}

TEST_CASE("mistakes in limits") {
    const std::string begin = "[exercises]\nface_sides = 1\n";
    const std::vector<std::pair<std::string, std::string>> rows = {
        {"[limits]\ncall_second = 1\n",
         ":4:1: 'call_second' is not a key of [limits]; expected one of "
         "call_seconds, cpu_seconds, case_seconds, all_seconds, memory_mib; "
         "did you mean call_seconds?"},
        {"[limits]\ncall_seconds = '1 s'\n",
         ":4:16: call_seconds is the text '1 s'; expected a number above 0.01 "
         "and at most 60"},
        {"[limits]\ncall_seconds = 0\n", ":4:16: call_seconds is 0;"},
        {"[limits]\ncpu_seconds = nan\n", ":4:15: cpu_seconds is nan;"},
        {"[limits]\ncase_seconds = 1e9\n", "at most 600"},
        {"[limits]\nall_seconds = -3\n", "at most 3600"},
        {"[limits]\nmemory_mib = 63\n",
         ":4:14: memory_mib is 63; expected a whole number from 64 to 16384"},
        {"[limits]\nmemory_mib = 512.5\n", ":4:14: memory_mib is 512.5;"},
        {"[limits]\ncall_seconds = 6\n",
         ":4:16: call_seconds is 6; expected at most the 5 of case_seconds"},
        {"[limits]\ncase_seconds = 21\n", "at most the 20 of all_seconds"},
        {"[limits.face_sides]\ncpu_seconds = 5.5\n",
         ":4:15: cpu_seconds is 5.5; expected at most the 5 of case_seconds"},
        {"[limits.face_side]\ncall_seconds = 1\n",
         ":3:9: 'face_side' is not an exercise; expected one of the 4 there "
         "are; did you mean face_sides?"},
        {"[limits.vertex_star]\ncall_seconds = 1\n",
         ":3:9: 01_traversal/vertex_star has limits, but is not of this "
         "assignment"},
        {"[limits.face_sides]\nmemory = 64\n",
         ":4:1: 'memory' is not a key of [limits.face_sides]; expected one"},
    };
    for (const auto& [text, expected] : rows)
        CHECK_THAT(message(begin + text), Containing(expected));
    CHECK_THAT(message("limits = 3\n" + begin),
               Containing(":1:10: limits is 3; expected a table"));
    CHECK(mistakes(begin + "[limits]\ncase_seconds = 1\n").empty());
}

TEST_CASE("a chapter is part of the suggestion where it was written") {
    CHECK_THAT(message("[exercises]\n\"01_travesal/face_sides\" = 1\n"),
               Containing("did you mean 01_traversal/face_sides?"));
}

TEST_CASE("weights that are no honest numbers are refused") {
    for (const char* weight : {"-1", "nan", "inf", "1001", "1e300", "[1]",
                               "{ of = 1 }", "2024-01-01", "'1'"}) {
        CAPTURE(weight);
        CHECK_THAT(message("[exercises]\nface_sides = " + std::string(weight)),
                   Containing("week_1.toml:2:14: the weight is"));
    }
}

TEST_CASE("mistakes in the notation have a place") {
    const auto found = mistakes("name = 'x'\n[exercises\nface_sides = 1\n");
    REQUIRE(found.size() == 1);
    CHECK(found[0].line == 2);
    CHECK_THAT(message("[exercises]\nface_sides = 1\nface_sides = 2\n"),
               Containing("week_1.toml:3:"));
}

TEST_CASE("a file without exercises is refused") {
    CHECK_THAT(message(""), Containing("no table [exercises] was found"));
    CHECK_THAT(message("[exercises]\n"), Containing("[exercises] is empty"));
    CHECK_THAT(message("exercises = 3\n"),
               Containing("exercises is 3; expected "
                          "a table"));
    CHECK_THAT(message("name = ''\n[exercises]\nface_sides = 1\n"),
               Containing("name is the text ''; expected a title"));
}

TEST_CASE("a file that cannot be read is named") {
    const course::TemporaryFolder folder;
    CHECK_THROWS_AS(read_assignment(folder / "none.toml", known),
                    AssignmentError);
    CHECK_THROWS_AS(read_assignment(folder.path(), known), AssignmentError);
}

TEST_CASE("the example has every exercise of chapters 0 to 2, once") {
    const std::filesystem::path root(COURSE_SOURCE_DIR);
    std::vector<std::string> all;
    for (const char* topic : {"00_table", "01_traversal", "02_border"})
        for (const auto& file :
             std::filesystem::directory_iterator(root / "exercises" / topic))
            if (file.path().filename().string().ends_with("_test.cpp"))
                all.push_back(topic + ("/" + file.path().stem().string()));
    for (std::string& name : all) name.resize(name.size() - 5);  // "_test"
    const Assignment assignment =
        read_assignment(root / "grader/assignments/first_light.toml", all);
    std::vector<std::string> named;
    for (const Assignment::Item& item : assignment.exercises)
        named.push_back(item.exercise);
    CHECK(std::is_sorted(named.begin(), named.end(),
                         [](const std::string& a, const std::string& b) {
                             return chapter(a) < chapter(b);
                         }));
    std::sort(named.begin(), named.end());
    std::sort(all.begin(), all.end());
    CHECK(named == all);
}

TEST_CASE("a file that is too long is not parsed") {
    const std::string line = "# a comment that fills the file\n";
    std::string text = "[exercises]\nface_sides = 1\n";
    while (text.size() + line.size() <= 16'384) text += line;
    CHECK(mistakes(text).empty());
    text.resize(16'385, '#');
    CHECK(message(text) ==
          "week_1.toml: the file has 16385 bytes; expected an assignment of "
          "at most 16384");
}

TEST_CASE("keys and lists of any depth are a mistake, not the end") {
    std::string keys = "a";
    while (keys.size() < 100'000) keys += ".a";
    CHECK(mistakes(keys + " = 1\n").size() == 1);
    CHECK(mistakes("[" + keys + "]\n").size() == 1);
    CHECK(mistakes("a = " + std::string(100'000, '[')).size() == 1);
    keys.resize(15'001);
    CHECK_FALSE(mistakes(keys + " = 1\n").empty());
    CHECK_FALSE(mistakes("[" + keys + "]\n").empty());
    CHECK_FALSE(mistakes("a = " + std::string(15'000, '[')).empty());
}
