// What happened to grades is kept, what is set by hand counts, and every report
// says that it was.
#include <SQLiteCpp/SQLiteCpp.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "course/runner/temporary_folder.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/history.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

using Kind = HistoryEntry::Kind;

constexpr const char* exercise = "01_traversal/face_sides";
constexpr const char* later_day = "2024-03-02T08:00:00Z";
const std::string reason = "oral exam, see SECRET protocol <b>";

GradeByHand by_hand(std::optional<double> points, std::string set_at) {
    return {"carla", exercise, points, reason, "prof", std::move(set_at)};
}

Attempt attempt(const std::string& key, ExerciseResult result,
                std::string when) {
    return {"carla",           exercise,        key,
            std::move(result), std::move(when), "hash of " + key};
}

/// The sample class with one grade set by hand: of dario, whose first exercise
/// ended in a fault, or of carla, who handed in nothing.
ClassResults class_with(std::size_t student, double points) {
    ClassResults all = sample_class();
    all.students[student].by_hand[0] = {all.run.students[student].id,
                                        exercise,
                                        points,
                                        reason,
                                        "prof",
                                        later_day};
    return all;
}

int count(const std::filesystem::path& file, const std::string& sql) {
    const SQLite::Database other(file);
    SQLite::Statement query(other, sql);
    REQUIRE(query.executeStep());
    return query.getColumn(0).getInt();
}

}  // namespace

TEST_CASE("the newest grade by hand holds until it is taken back") {
    const course::TemporaryFolder folder;
    const std::filesystem::path file = folder / "g.sqlite";
    {
        Gradebook book(file);
        book.set_by_hand(by_hand(3, "2024-03-02T08:00:00Z"));
        book.set_by_hand(by_hand(7.5, "2024-03-02T09:00:00Z"));
    }
    Gradebook book(file);
    const auto holding = book.set_by_hand("carla");
    REQUIRE(holding.size() == 1);
    CHECK(holding[0].points == 7.5);
    CHECK(holding[0].reason == reason);
    CHECK(holding[0].user == "prof");
    CHECK(book.set_by_hand("anna.rossi").empty());
    book.set_by_hand(by_hand(std::nullopt, "2024-03-03T09:00:00Z"));
    CHECK(book.set_by_hand("carla").empty());
    // No row has gone.
    CHECK(count(file, "SELECT count(*) FROM set_by_hand") == 3);
}

TEST_CASE("a grade by hand outlasts results that come after it") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const ClassResults sample = sample_class();
    record(book, sample);
    book.set_by_hand(by_hand(7.5, later_day));
    book.record(book.begin_run(sample_run()),
                attempt("new", *all_accepted()[0], "2024-03-04T08:00:00Z"));
    const ClassResults all = class_results(book, sample_assignment());
    const auto score = score_of(all.students[3], 0);
    REQUIRE(score.has_value());
    CHECK(score->points == 7.5);
    CHECK(score->by_hand);
    CHECK(count(folder / "g.sqlite",
                "SELECT 10 * set_points FROM standing WHERE student = 'carla' "
                "AND exercise = '01_traversal/face_sides'") == 75);
}

TEST_CASE("the history has every result, again, proposed and by hand") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    Run first = sample_run();
    first.user = "assistant";
    const int run = book.begin_run(first);
    book.record(run,
                attempt("a", *wrong_and_endless()[0], "2024-03-01T09:31:00Z"));
    book.record(run, attempt("b", *all_accepted()[0], "2024-03-01T09:32:00Z"));
    book.set_by_hand(by_hand(7.5, "2024-03-01T10:00:00Z"));
    Run again = sample_run();
    again.started_at = "2024-03-05T09:00:00Z";
    book.reuse(book.begin_run(again), "carla", exercise, "a");
    again.proposed = true;
    again.started_at = "2024-03-06T09:00:00Z";
    book.reuse(book.begin_run(again), "carla", exercise, "b");
    book.set_by_hand(by_hand(std::nullopt, "2024-03-07T10:00:00Z"));

    const auto all = book.history("carla");
    REQUIRE(all.size() == 6);
    CHECK((all[0].kind == Kind::judged));
    CHECK(all[0].source == "hash of a");
    CHECK(all[0].points == 5);
    CHECK(all[0].suite == "a1b2c3");
    CHECK(all[0].user == "assistant");
    CHECK(all[1].points == 10);
    CHECK((all[2].kind == Kind::set_by_hand));
    CHECK(all[2].points == 7.5);
    CHECK((all[3].kind == Kind::counted_again));
    CHECK(all[3].when == "2024-03-05T09:00:00Z");
    CHECK(all[3].run == 2);
    CHECK_FALSE(all[3].proposed);
    CHECK(all[4].proposed);
    CHECK((all[5].kind == Kind::taken_back));
    CHECK(book.history("anna.rossi").empty());
    const auto runs = book.runs();
    REQUIRE(runs.size() == 3);
    CHECK((runs[0].facts.suites == first.suites));
    CHECK(runs[0].facts.user == "assistant");
    CHECK(runs[2].facts.proposed);
}

TEST_CASE("two runs differ in the results that counted at their ends") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int first = book.begin_run(sample_run());
    book.record(first, attempt("a", *wrong_and_endless()[0], "t"));
    const int second = book.begin_run(sample_run());
    book.record(second, attempt("b", *all_accepted()[0], "t"));
    Run proposal = sample_run();
    proposal.proposed = true;
    const int third = book.begin_run(proposal);
    book.record(third, attempt("c", *crashes()[0], "t"));
    const int fourth = book.begin_run(sample_run());
    book.record(fourth, {"anna.rossi", exercise, "d", *all_accepted()[0], "t"});

    const auto changed = book.differences(first, second);
    REQUIRE(changed.size() == 1);
    CHECK(changed[0].old_points == 5);
    CHECK(changed[0].points == 10);
    // What is only proposed counts in its own run, and not in a later one.
    REQUIRE(book.differences(second, third).size() == 1);
    CHECK(book.differences(second, third)[0].points == 5);
    const auto last = book.differences(second, fourth);
    REQUIRE(last.size() == 1);
    CHECK(last[0].student == "anna.rossi");
    CHECK_FALSE(last[0].old_verdict.has_value());
}

TEST_CASE("the exports have every entry, and names stay data") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    record(book, sample_class());
    GradeByHand formula = by_hand(7.5, later_day);
    formula.reason = "=cmd()";
    book.set_by_hand(formula);
    const std::string csv = history_csv(book);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 5 * 3 + 1);
    CHECK_THAT(csv, Containing("2024-03-02T08:00:00Z,set_by_hand,carla,carla,"
                               "01_traversal/face_sides,,,,7.5,,,,prof,"
                               "\"'=cmd()\""));
    CHECK_THAT(csv, Containing(",\"'=cmd|' /C calc'!A0\","));
    const auto json = nlohmann::json::parse(history_json(book));
    CHECK(json.at("runs").size() == 1);
    CHECK(json.at("runs")[0].at("suites").at(exercise) == "a1b2c3");
    CHECK(json.at("entries").size() == 5 * 3 + 1);
    CHECK(history_json(book) == history_json(book));
}

TEST_CASE("the instructor reads the reason, the student that it was by hand") {
    const ClassResults all = class_with(1, 9);
    const StudentResults& student = all.students[1];
    const std::string page = class_page(summary_of(all)).text;
    CHECK_THAT(page, Containing("Points set by hand"));
    CHECK_THAT(page, Containing("oral exam, see SECRET protocol &lt;b&gt;"));
    CHECK_THAT(page, Containing("<small>9*</small>"));
    CHECK_THAT(student_text(all, student, Colour::off),
               Containing("set by hand, 2024-03-02 08:00 UTC by prof; the "
                          "grader found 5: oral exam"));
    CHECK_THAT(grades_csv(summary_of(all)),
               Containing("face_sides: oral exam, see SECRET protocol"));
    CHECK_THAT(class_table(summary_of(all), Colour::off), Containing("WA 9*"));
    const std::string feedback = student_page(all, student).text;
    CHECK_THAT(feedback, Containing("9 of 10"));
    CHECK_THAT(feedback, Containing("set by hand"));
    CHECK_THAT(feedback, !Containing("SECRET"));
    const std::string json = gradescope_json(all, student);
    CHECK_THAT(json, Containing("the points were set by hand: 9 of 10"));
    CHECK_THAT(json, !Containing("SECRET"));
    // The others' pages say nothing of it.
    CHECK_THAT(student_page(all, all.students[0]).text,
               !Containing("set by hand"));
}

TEST_CASE("points by hand count where the grader has none") {
    const ClassResults missing = class_with(3, 4);
    CHECK(total(missing, scores_of(missing.students[3])).total == 4);
    const ClassResults faulty = class_with(4, 6);
    const Scores scores = scores_of(faulty.students[4]);
    CHECK((status(scores) == Status::partial));
    CHECK(total(faulty, scores).total.has_value());
}

TEST_CASE("the program sets points by hand, and takes them back") {
    const course::TemporaryFolder folder;
    {
        Gradebook book(folder / "gradebook.sqlite");
        record(book, sample_class());
    }
    const std::string out = folder.path().string();
    const auto says = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--out", out});
        return grader_says(words);
    };
    const Said set = says(
        {"override", "carla", "face_sides", "7.5", "--reason", "oral exam"});
    INFO(set.text);
    CHECK(set.code == 0);
    const Said shown = says({"show", "carla", "--history"});
    CHECK_THAT(shown.text, Containing("7.5 of 10"));
    CHECK_THAT(shown.text, Containing("the grader found 0: oral exam"));
    CHECK_THAT(shown.text, Containing("face_sides  set by hand to 7.5 by "));
    CHECK(says({"override", "carla", "face_sides", "--undo", "--reason", "x"})
              .code == 0);
    CHECK_THAT(says({"show", "carla"}).text, !Containing("set by hand"));
    CHECK(says({"history", "--csv", out + "/h.csv"}).code == 0);
    CHECK_THAT(file_contents(folder / "h.csv"), Containing("taken_back"));
}

TEST_CASE("points by hand that make no sense are refused, with what would") {
    const course::TemporaryFolder folder;
    {
        Gradebook book(folder / "gradebook.sqlite");
        record(book, sample_class());
    }
    const auto refused = [&](std::vector<std::string> words,
                             const std::string& why) {
        words.insert(words.begin(), "override");
        words.insert(words.end(), {"--out", folder.path().string()});
        const Said said = grader_says(words);
        INFO(said.text);
        CHECK(said.code == 2);
        CHECK_THAT(said.text, Containing(why));
    };
    const std::string r = "--reason";
    refused({"carla", "face_sides", "75", r, "x"}, "expected 0 to 10");
    refused({"carla", "face_sides", "nan", r, "x"}, "expected 0 to 10");
    refused({"carla", "face_sides", "7"}, r + " is required");
    refused({"carla", "face_sides", "7", r, " "}, "--reason is empty");
    refused({"carla", "face_sides", r, "x"}, "either points or --undo");
    refused({"carla", "face_sides", "--undo", r, "x"}, "nothing was set");
    refused({"carlo", "face_sides", "7", r, "x"}, "did you mean carla?");
    refused({"carla", "face_side", "7", r, "x"}, "did you mean face_sides?");
    CHECK(Gradebook(folder / "gradebook.sqlite").set_by_hand("carla").empty());
}
