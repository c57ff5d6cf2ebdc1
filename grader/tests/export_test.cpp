// Grades on their way into the tables of course platforms.
#include <fstream>
#include <nlohmann/json.hpp>

#include "course/report/text.h"
#include "course/runner/temporary_folder.h"
#include "grader/report/canvas_gradebook.h"
#include "grader/report/moodle_worksheet.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"
#include "grader/tests/platform_tables.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace fs = std::filesystem;

namespace {

Cells no_cells(std::size_t) {
    return {};
}

Grade moodle_grade(const PlatformStudent& student) {
    return {student.full_name() + "_" + student.key + "_assignsubmission_file",
            student.key, student.full_name()};
}

Grade canvas_grade(const PlatformStudent& student) {
    return {"x_" + student.key, student.key, "x"};
}

std::vector<std::string> lines(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

/// Numbers of the lines, from 1, in which two texts differ.
std::vector<std::size_t> differing_lines(const std::string& a,
                                         const std::string& b) {
    const auto as = lines(a), bs = lines(b);
    REQUIRE(as.size() == bs.size());
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < as.size(); ++k)
        if (as[k] != bs[k]) numbers.push_back(k + 1);
    return numbers;
}

std::string all_of(const std::vector<std::string>& texts) {
    std::string text;
    for (const std::string& one : texts) text += one + "\n";
    return text;
}

FilledTable canvas(const std::string& table, std::vector<Grade> grades,
                   const std::string& column = "First light") {
    return filled_gradebook(table, grades, column);
}

/// A worksheet of a few rows: number, name, group, grade.
std::string small_worksheet(const std::vector<std::string>& rows) {
    std::string text =
        "Identifier,Full name,Email address,Group,Grade,Maximum Grade,Grade "
        "can be changed,Last modified (grade),Feedback comments\n";
    for (const std::string& row : rows) text += row + "\n";
    return text;
}

Grade grade(const std::string& student, const std::string& key,
            const std::string& person, std::optional<double> total = 5) {
    return {student, key, person,
            total,   10,  total ? Status::complete : Status::grader_fault,
            "well"};
}

std::string moodle(const std::string& sheet, const std::vector<Grade>& grades,
                   std::vector<std::string>& left) {
    const FilledTable filled = filled_worksheet(sheet, grades, {});
    left = filled.left;
    return filled.text;
}

}  // namespace

TEST_CASE("only grades and feedback of Moodle's worksheet change") {
    for (const Dialect& dialect : dialects()) {
        INFO(dialect.name);
        const auto grades = forty_grades(moodle_grade);
        const auto cells = [&](std::size_t k) {
            return Cells{
                decimals(course::points_text(10 * points_of_student(k)),
                         dialect),
                grades[k].feedback};
        };
        const FilledTable filled =
            filled_worksheet(moodle_worksheet(dialect, no_cells), grades, {});
        const std::string expected = moodle_worksheet(dialect, cells);
        INFO(first_difference(filled.text, expected));
        CHECK(filled.text == expected);
        CHECK(filled.filled == 40);
        CHECK(all_of(filled.left).empty());
        CHECK_THAT(all_of(filled.notes), Containing("10 of the assignment are "
                                                    "100 of the table"));
        CHECK(filled_worksheet(filled.text, grades, {}).text == expected);
    }
}

TEST_CASE("only one column of Canvas's gradebook changes") {
    for (const Dialect& dialect : dialects()) {
        INFO(dialect.name);
        const auto cells = [&](std::size_t k) {
            return Cells{decimals(course::points_text(2 * points_of_student(k)),
                                  dialect),
                         ""};
        };
        const FilledTable filled = canvas(canvas_gradebook(dialect, no_cells),
                                          forty_grades(canvas_grade));
        const std::string expected = canvas_gradebook(dialect, cells);
        INFO(first_difference(filled.text, expected));
        CHECK(filled.text == expected);
        CHECK(filled.filled == 40);
        CHECK(all_of(filled.left).empty());
        CHECK_THAT(all_of(filled.notes), Containing("10 of the assignment are "
                                                    "20 of the table"));
    }
}

TEST_CASE("a column without decimals has a comma where other columns have") {
    const std::string table =
        "Student;ID;SIS Login ID;First light (1);Quiz (2)\n"
        "Points Possible;;;10;10\n"
        "\"Rossi, Anna\";7;anna;;8,5\n";
    CHECK_THAT(canvas(table, {grade("x", "7", "x", 2.5)}).text,
               Containing(";anna;2,5;8,5"));
}

TEST_CASE("a student without a grade gets none, and is named") {
    auto grades = forty_grades(moodle_grade);
    grades[3].total.reset();
    grades[3].status = Status::grader_fault;
    const std::string before = moodle_worksheet(dialects()[0], no_cells);
    const FilledTable filled = filled_worksheet(before, grades, {});
    CHECK(filled.filled == 39);
    REQUIRE(filled.left.size() == 1);
    CHECK_THAT(filled.left[0], Containing("Anna Weber; Max_482921"));
    CHECK_THAT(filled.left[0], Containing("grader fault"));
    const auto expected = [&](std::size_t k) {
        return k == 3 ? Cells{}
                      : Cells{course::points_text(10 * points_of_student(k)),
                              grades[k].feedback};
    };
    CHECK(filled.text == moodle_worksheet(dialects()[0], expected));

    auto for_canvas = forty_grades(canvas_grade);
    for_canvas[3].total.reset();
    const std::string book = canvas_gradebook(dialects()[0], [](std::size_t) {
        return Cells{"1", ""};
    });
    const FilledTable filled_book = canvas(book, for_canvas);
    CHECK(lines(filled_book.text)[6] == lines(book)[6]);
    CHECK(filled_book.left.size() == 1);
}

TEST_CASE("students without a row and rows without a student are named") {
    std::vector<std::string> left;
    const std::string sheet = small_worksheet(
        {"Participant 1,Anna Rossi,a@x,,,10.00,Yes,-,",
         "Participant 2,\"Bruno \x1b[31m\",b@x,,,10.00,Yes,-,"});
    const std::string filled =
        moodle(sheet,
               {grade("Anna Rossi_1_assignsubmission_file", "1", "Anna Rossi"),
                grade("Zed_9_assignsubmission_file", "9", "Zed")},
               left);
    CHECK(differing_lines(sheet, filled) == std::vector<std::size_t>{2});
    REQUIRE(left.size() == 2);
    CHECK_THAT(left[0], Containing("Zed_9_assignsubmission_file: has no row"));
    CHECK_THAT(left[1], Containing("line 3: Bruno \\x1B"));
}

TEST_CASE("another assignment's worksheet takes no grade by name") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 71,Anna Rossi,a@x,,,10.00,Yes,-,"});
    CHECK(
        moodle(sheet,
               {grade("Anna Rossi_1_assignsubmission_file", "1", "Anna Rossi")},
               left) == sheet);
    CHECK(left.size() == 2);
}

TEST_CASE("numbers are read from names as exports and ingest write them") {
    ClassSummary results = summary_of(sample_class());
    auto& students = results.run.students;
    students[0].name = "Anna Rossi_1234_assignsubmission_file";
    students[1].name = "Bruno Bo_77";
    students[2].name = "rossianna_LATE_55_4711_prev.cpp";
    students[3].name = "anna_rossi";
    const auto moodle_grades = grades_for(results, Platform::moodle);
    CHECK(moodle_grades[0].key == "1234");
    CHECK(moodle_grades[0].person == "Anna Rossi");
    CHECK(moodle_grades[1].key == "77");
    CHECK(moodle_grades[1].person == "Bruno Bo");
    CHECK(moodle_grades[3].key.empty());
    CHECK(grades_for(results, Platform::canvas)[2].key == "55");
}

TEST_CASE("a folder without a number is found by name or address") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 1,Anna  ROSSI,a@x,,,10.00,Yes,-,",
                         "Participant 2,Bruno Bo,b@x,,,10.00,Yes,-,",
                         "Participant 3,Carla Ca,c@x,,,10.00,Yes,-,",
                         "Participant 4,Carla Ca,d@x,,,10.00,Yes,-,"});
    const std::string filled =
        moodle(sheet,
               {grade("anna_rossi", "", "anna_rossi"), grade("b@x", "", "b@x"),
                grade("Carla Ca", "", "Carla Ca")},
               left);
    CHECK(differing_lines(sheet, filled) == std::vector<std::size_t>{2, 3});
    CHECK_THAT(all_of(left), Containing("Carla Ca: lines 4, 5 all fit"));
}

TEST_CASE("two submissions of one student fill nothing in") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 1,Anna Rossi,a@x,,,10.00,Yes,-,"});
    CHECK(moodle(sheet,
                 {grade("one", "1", "Anna Rossi"), grade("two", "1", "Anna")},
                 left) == sheet);
    CHECK_THAT(all_of(left), Containing("one and two both fit"));
}

TEST_CASE("all members of a team get its grade") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 1,Anna Rossi,a@x,Team 1,,10.00,Yes,-,",
                         "Participant 2,Bruno Bo,b@x,Team 2,,10.00,Yes,-,",
                         "Participant 3,Carla Ca,c@x,Team 1,,10.00,Yes,-,"});
    const std::string filled = moodle(
        sheet, {grade("Team 1_77_assignsubmission_file", "77", "Team 1")},
        left);
    CHECK(differing_lines(sheet, filled) == std::vector<std::size_t>{2, 4});
    CHECK_THAT(filled, Containing("c@x,Team 1,5,10.00,Yes,-,well"));
}

TEST_CASE("a grade that may not be changed stays") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 1,Anna Rossi,a@x,,3.00,10.00,No,-,"});
    CHECK(moodle(sheet, {grade("a", "1", "Anna Rossi")}, left) == sheet);
    CHECK_THAT(all_of(left), Containing("cannot be changed"));
}

TEST_CASE("more points than Moodle takes are its maximum, which is said") {
    std::vector<std::string> left;
    const std::string sheet =
        small_worksheet({"Participant 1,Anna Rossi,a@x,,,10.00,Yes,-,"});
    const auto filled =
        moodle(sheet, {grade("a", "1", "Anna Rossi", 12)}, left);
    CHECK_THAT(filled, Containing("a@x,,10,10.00"));
    CHECK_THAT(all_of(left), Containing("12 points are above"));
}

TEST_CASE("columns of other languages are named by the instructor") {
    std::string sheet =
        small_worksheet({"Participant 1,Anna Rossi,a@x,,,10.00,Yes,-,"});
    const std::string grades = ",Grade,", other = ",Puntuazioa,";
    sheet.replace(sheet.find(grades), grades.size(), other);
    const std::vector<Grade> one = {grade("a", "1", "Anna Rossi")};
    CHECK_THROWS_WITH(filled_worksheet(sheet, one, {}),
                      Containing("--grade-column") && Containing("Puntuazioa"));
    CHECK_THROWS_WITH(filled_worksheet(sheet, one, {"Nota", ""}),
                      Containing("there is no column \"Nota\""));
    MoodleOptions options{"puntuazioa", "", false};
    CHECK_THAT(filled_worksheet(sheet, one, options).text,
               Containing("a@x,,5,10.00,Yes,-,\n"));
}

TEST_CASE("what is no table of the platform is refused") {
    const std::vector<Grade> none;
    CHECK_THROWS_WITH(filled_worksheet("a,b\n1,2\n", none, {}),
                      Containing("not a grading worksheet"));
    CHECK_THROWS_WITH(canvas("a,b\n1,2\n", none), Containing("\"ID\""));
    const std::string book = canvas_gradebook(dialects()[0], no_cells);
    CHECK_THROWS_WITH(
        canvas(book, none, "Second light"),
        Containing("no column") && Containing("\"First light (4711)\""));
}

TEST_CASE("Canvas's column is known by name, number or both") {
    const std::string book = canvas_gradebook(dialects()[0], no_cells);
    const auto grades = forty_grades(canvas_grade);
    const std::string filled = canvas(book, grades).text;
    CHECK(canvas(book, grades, "4711").text == filled);
    CHECK(canvas(book, grades, "first light").text == filled);
    CHECK(canvas(book, grades, "First light (4711)").text == filled);
    CHECK(canvas(book, grades, "4712").text != filled);
}

TEST_CASE("an excused student stays excused") {
    const std::string book = canvas_gradebook(dialects()[0], [](std::size_t k) {
        return Cells{k == 5 ? "EX" : "", ""};
    });
    const FilledTable filled = canvas(book, forty_grades(canvas_grade));
    CHECK(lines(filled.text)[8] == lines(book)[8]);
    CHECK(filled.filled == 39);
    CHECK_THAT(all_of(filled.left), Containing("line 9 has EX"));
}

TEST_CASE("Canvas's students are found by their ids, then by name") {
    const std::string book = canvas_gradebook(dialects()[0], no_cells);
    const auto by = [&](const std::string& folder) {
        return differing_lines(
            book, canvas(book, {grade(folder, "", folder, 1)}).text);
    };
    const std::vector<std::size_t> line = {5};
    CHECK(by("482907") == line);
    CHECK(by("Suser01") == line);
    CHECK(by("user01") == line);
    CHECK(by("Núñez, Anna") == line);
    CHECK(by("anna_Núñez") == line);
    CHECK(by("Núñez Anna") == line);
    CHECK(by("nobody").empty());
}

TEST_CASE("feedback says points and verdicts, and no word of the student's") {
    const ClassSummary results = summary_of(sample_class());
    const auto grades = grades_for(results, Platform::moodle);
    REQUIRE(grades.size() == results.students.size());
    CHECK(grades[0].feedback ==
          "35 of 35 points. face_sides: 10 of 10, accepted; vertex_star: 10 of "
          "10, accepted, weight 1.5; boundary_walk: 10 of 10, accepted.");
    CHECK_FALSE(grades[4].total);
    CHECK(grades[4].status == Status::grader_fault);
    for (const Grade& one : grades)
        CHECK(one.feedback.find_first_of("<>=\n\"") == one.feedback.npos);
}

TEST_CASE("feedback says what was set by hand, and what came late") {
    ClassSummary results = summary_of(sample_class());
    results.students[0][2] = Score{course::Verdict::wrong_answer, 4, true};
    results.students[0].late = {2, 0.5};
    const Grade grade = grades_for(results, Platform::moodle)[0];
    CHECK(grade.total == 14.5);
    CHECK(grade.feedback ==
          "14.5 of 35 points. face_sides: 10 of 10, accepted; vertex_star: 10 "
          "of 10, accepted, weight 1.5; boundary_walk: 4 of 10, wrong answer, "
          "set by hand. Handed in 2 days late, 50 % counts.");
}

TEST_CASE("each member of a team that the export names gets its grade") {
    ClassSummary results = summary_of(sample_class());
    results.run.students[0].members = {{"Anna Rossi", "4711", "a@x"},
                                       {"Bruno Bo", "", "b@x"}};
    const auto grades = grades_for(results, Platform::canvas);
    REQUIRE(grades.size() == results.students.size() + 1);
    CHECK(grades[0].key == "4711");
    CHECK(grades[1].student == "Bruno Bo");
    CHECK(grades[0].total == grades[1].total);
}

namespace {

/// A run's folder with the sample class, and a worksheet for its students.
struct Exported {
    Exported() {
        const ClassResults results = sample_class();
        fs::create_directories(folder / "out");
        Gradebook book(folder / "out/gradebook.sqlite");
        record(book, results);
        std::ofstream(sheet, std::ios::binary) << text;
        std::ofstream(folder / "a.toml")
            << "name = \"First\"\n[exercises]\nface_sides = 1\n"
               "vertex_star = 1.5\nboundary_walk = 1\n";
    }
    Said exports(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(),
                         {"export", "--out", folder / "out", "--assignment",
                          folder / "a.toml"});
        return grader_says(arguments);
    }

    course::TemporaryFolder folder;
    fs::path sheet = folder / "sheet.csv";
    std::string text =
        small_worksheet({"Participant 1,Anna Rossi,anna.rossi,,,35.00,Yes,-,",
                         "Participant 2,Carla,carla,,,35.00,Yes,-,"});
};

}  // namespace

TEST_CASE("a worksheet is filled in its place, with a backup beside it") {
    const Exported run;
    const Said said = run.exports({"--moodle", run.sheet});
    INFO(said.text);
    CHECK(said.code == 1);
    CHECK_THAT(said.text, Containing("cmd"));
    CHECK(course::read_file(run.sheet.string() + ".bak") == run.text);
    const std::string filled = course::read_file(run.sheet);
    CHECK_THAT(filled, Containing(",anna.rossi,,35,35.00,Yes,-,"));
    CHECK_THAT(filled, Containing(",carla,,0,35.00,Yes,-,"));
    CHECK(differing_lines(run.text, filled) == std::vector<std::size_t>{2, 3});
}

TEST_CASE("a worksheet is filled into another file, and itself stays") {
    const Exported run;
    const fs::path to = run.folder / "filled.csv";
    CHECK(run.exports({"--moodle", run.sheet, "--to", to}).code == 1);
    CHECK(course::read_file(run.sheet) == run.text);
    CHECK_THAT(course::read_file(to), Containing(",anna.rossi,,35,"));
    CHECK_FALSE(fs::exists(run.sheet.string() + ".bak"));
    CHECK(run.exports({"--moodle", run.sheet, "--to", to, "--no-feedback"})
              .code == 1);
    CHECK_THAT(course::read_file(to), Containing(",35,35.00,Yes,-,\n"));
}

TEST_CASE("what cannot be exported changes nothing") {
    const Exported run;
    std::ofstream(run.folder / "no.csv") << "a,b\n1,2\n";
    const std::string other = run.folder / "no.csv";
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{
             {"--moodle", other},
             {"--canvas", other},
             {"--moodle", run.folder / "nothing.csv"},
             {"--moodle", run.sheet, "--grade-column", "Nota"},
             {"--to", run.folder / "x.csv"},
             {}}) {
        INFO(all_of(arguments));
        const Said said = run.exports(arguments);
        INFO(said.text);
        CHECK(said.code == 2);
    }
    CHECK(course::read_file(other) == "a,b\n1,2\n");
    CHECK(course::read_file(run.sheet) == run.text);
}

TEST_CASE("all results are there for other programs, without false grades") {
    const Exported run;
    const fs::path file = run.folder / "results.json";
    const Said said = run.exports({"--json", file});
    INFO(said.text);
    REQUIRE(said.code == 0);
    const auto json = nlohmann::json::parse(course::read_file(file));
    CHECK(json.at("version") == 1);
    CHECK(json.at("assignment").at("max") == 35);
    CHECK(json.at("run").at("seed") == "18446744073709551615");
    const auto& students = json.at("students");
    REQUIRE(students.size() == 5);
    CHECK(students[1].at("name") == "anna.rossi");
    CHECK(students[1].at("total") == 35);
    CHECK(students[3].at("total") == 0);
    CHECK(students[3].at("status") == "nothing submitted");
    CHECK_FALSE(students[4].contains("total"));
    CHECK(students[4].at("status") == "grader fault");
    const auto& failed = students[2].at("exercises")[0];
    CHECK(failed.at("verdict") == "wrong_answer");
    CHECK(failed.at("cases")[0].at("failures")[0].at("expected") == "3");
    CHECK(failed.at("cases")[2].at("is_hidden") == true);
    CHECK(run.exports({"--json", run.folder / "again.json"}).code == 0);
    CHECK(course::read_file(run.folder / "again.json") ==
          course::read_file(file));
}

TEST_CASE("JSON of hostile names and outputs can be read, and is short") {
    const Exported run;
    const fs::path file = run.folder / "results.json";
    REQUIRE(run.exports({"--json", file}).code == 0);
    const std::string text = course::read_file(file);
    CHECK(text.size() < 100'000);  // one student printed a million bytes
    CHECK(course::visible(text) == text);
    CHECK(contains(text, "Bruno <script>"));
}
