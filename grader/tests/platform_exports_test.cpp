// Whole classes from three platforms, from the download to the table of grades.
#include "grader/tests/platform_exports.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "grader/report/csv_table.h"
#include "grader/tests/class_on_disk.h"
#include "grader/tests/grader_program.h"

using namespace grader;
using namespace grader::tests;

namespace {

using Kind = MadeUp::Kind;

class Download {
public:
    explicit Download(const std::string& bytes) {
        disk_.file("export.zip", bytes);
    }
    SubmittedClass find() const {
        return find_submissions(zip(), made_up_files);
    }
    std::filesystem::path zip() const { return disk_.at("export.zip"); }
    ClassOnDisk& disk() { return disk_; }

private:
    ClassOnDisk disk_;
};

const Submission* with_key(const SubmittedClass& all, const std::string& key) {
    for (const Submission& one : all.submissions)
        if (one.key == key) return &one;
    return nullptr;
}

/// Whether these are the files of that student, all of them and newest.
void check_files(const SubmittedClass& all, const Submission& one,
                 const MadeUp& who) {
    for (std::size_t k = 0; k < made_up_files.size(); ++k) {
        CAPTURE(made_up_files[k]);
        REQUIRE(one.files[k].has_value() == (who.kind != Kind::empty));
        if (one.files[k])
            CHECK(all.bytes(one, k) == who.file(made_up_files[k]));
    }
}

bool says_of(const std::vector<std::string>& notes, const std::string& text) {
    return contains(joined(notes), text);
}

constexpr const char* assignment_text =
    "name = 'One'\n"
    "due = 2026-12-11T23:59:00\n"
    "time_zone = 'Europe/Rome'\n"
    "[late]\n"
    "policy = 'percent_per_day'\n"
    "percent_per_day = 10\n"
    "[exercises]\n"
    "face_sides = 1\n";

std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What a run of the export with that assignment writes as grades.csv.
CsvTable graded(Download& download, const std::string& assignment,
                const std::vector<std::string>& more = {}) {
    download.disk().file("one.toml", assignment);
    const auto out = download.disk().at("out");
    std::vector<std::string> arguments = {
        "run",          download.zip(),
        "--out",        out,
        "--assignment", download.disk().at("one.toml"),
        "--repeats",    "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Said said = grader_says(arguments);
    CAPTURE(said.text);
    REQUIRE(said.code == 0);
    return CsvTable(read(out / "grades.csv"));
}

/// In the row where that column has that value.
std::string value(const CsvTable& table, const std::string& column,
                  const std::string& key, const std::string& wanted) {
    const std::size_t at = column_named(table, column).value();
    for (std::size_t row = 1; row < table.rows(); ++row)
        if (table.value(row, at) == key)
            return table.value(row, column_named(table, wanted).value());
    return "no row";
}

/// Whether so much of what the exercise gave counts in the row of that number.
/// How much that is depends on a machine's load: limits are in seconds.
bool counts(const CsvTable& grades, const std::string& number, double factor) {
    const double points =
        std::stod(value(grades, "number", number, "face_sides"));
    const double total = std::stod(value(grades, "number", number, "total"));
    return std::abs(total - factor * points) < 0.01;
}

}  // namespace

TEST_CASE("the exports are the same each time") {
    CHECK(moodle_export() == moodle_export());
    CHECK(canvas_export() == canvas_export());
    CHECK(gradescope_export() == gradescope_export());
}

TEST_CASE("a class of 40 from Moodle comes in whole") {
    const Download moodle(moodle_export());
    const SubmittedClass all = moodle.find();
    CHECK(all.submissions.size() == class_size);
    for (const MadeUp& one : made_up_class()) {
        if (one.kind == Kind::misnamed) continue;
        CAPTURE(one.name());
        const Submission* found =
            with_key(all, std::to_string(moodle_number(one)));
        REQUIRE(found != nullptr);
        CHECK(found->person == one.name());
        check_files(all, *found, one);
    }
    CHECK(says_of(all.notes, made_up(19).name() + ": is not named as Moodle"));
}

TEST_CASE("a class of 40 from Canvas comes in whole") {
    const Download canvas(canvas_export());
    const SubmittedClass all = canvas.find();
    CHECK(all.submissions.size() == class_size);
    for (const MadeUp& one : made_up_class()) {
        CAPTURE(one.name());
        const Submission* found =
            with_key(all, std::to_string(canvas_number(one)));
        REQUIRE(found != nullptr);
        CHECK(found->marked_late == (one.kind == Kind::late));
        check_files(all, *found, one);
    }
    CHECK(says_of(all.notes, made_up(19).name() + ".cpp: is not named as"));
}

TEST_CASE("a class of 40 from Gradescope comes in whole") {
    const Download gradescope(gradescope_export());
    const SubmittedClass all = gradescope.find();
    std::set<std::string> people;
    for (const Submission& one : all.submissions)
        for (const Member& member : one.members) people.insert(member.number);
    CHECK(people.size() == class_size);
    for (const MadeUp& one : made_up_class()) {
        if (hands_in_with_another(one)) continue;
        CAPTURE(one.name());
        const Submission* found =
            with_key(all, std::to_string(gradescope_number(one)));
        REQUIRE(found != nullptr);
        CHECK(found->members.size() == gradescope_team(one).size());
        CHECK(found->members[0].name == one.name());
        check_files(all, *found, one);
    }
    CHECK(says_of(all.notes, "submission_10005: of " + made_up(5).name()));
}

TEST_CASE("late work from Gradescope costs what the assignment says") {
    if (!has_sandbox()) return;
    Download gradescope(gradescope_export());
    const CsvTable grades = graded(gradescope, assignment_text);
    CHECK(grades.rows() == 1 + class_size);  // a line for each member
    for (const MadeUp& one : made_up_class()) {
        CAPTURE(one.name());
        const std::string number = std::to_string(100 + one.number);
        const bool late = one.kind == Kind::late && one.number != 33;
        CHECK(value(grades, "number", number, "late") ==
              (late ? "2 days late, 80 % counts" : ""));
        CHECK(counts(grades, number, late ? 0.8 : 1));
        CHECK(value(grades, "number", number, "status") ==
              (one.kind == Kind::empty ? "nothing submitted" : "complete"));
    }
}

TEST_CASE("teams from Moodle get their members and times by the worksheet") {
    if (!has_sandbox()) return;
    Download moodle(moodle_team_export());
    moodle.disk().file("worksheet.csv", moodle_team_worksheet());
    const CsvTable grades =
        graded(moodle, std::string("teams = true\n") + assignment_text,
               {"--times", moodle.disk().at("worksheet.csv")});
    CHECK(grades.rows() == 1 + class_size);
    for (const MadeUp& one : made_up_class()) {
        CAPTURE(one.name());
        const std::string number = std::to_string(moodle_number(one));
        CHECK(counts(grades, number, team_of(one) == 3 ? 0.8 : 1));
        CHECK(value(grades, "number", number, "status") == "complete");
    }
}

namespace {

/// Moodle's worksheet of the class, nobody graded yet.
std::string moodle_worksheet() {
    std::string sheet =
        "Identifier,Full name,Status,Grade,Maximum Grade,Grade can be changed,"
        "Last modified (grade),Feedback comments\r\n";
    for (const MadeUp& one : made_up_class())
        sheet +=
            fmt::format("Participant {},\"{}\",Submitted,,10.00,Yes,-,\r\n",
                        moodle_number(one), one.name());
    return sheet;
}

/// Canvas's gradebook of the class, with a column of another assignment.
std::string canvas_gradebook() {
    std::string book =
        "Student,ID,SIS Login ID,Section,Zero (11),One (12),Final Score\n"
        "    Points Possible,,,,5,10,(read only)\n";
    for (const MadeUp& one : made_up_class())
        book += fmt::format("\"{}, {}\",{},user{},A,3,,50\n", one.last,
                            one.first, canvas_number(one), one.number);
    return book;
}

/// The table with the grades of download's run, and nothing else changed.
CsvTable filled(Download& download, const char* option,
                const std::string& table,
                const std::vector<std::string>& changing) {
    download.disk().file("table.csv", table);
    const Said said =
        grader_says({"export", "--out", download.disk().at("out"),
                     "--assignment", download.disk().at("one.toml"), option,
                     download.disk().at("table.csv")});
    CAPTURE(said.text);
    CHECK(said.code <= 1);
    const CsvTable before(table), after(read(download.disk().at("table.csv")));
    REQUIRE(after.rows() == before.rows());
    // To the byte it is proved by export_test.
    for (std::size_t column = 0; column < before.columns(); ++column)
        for (std::size_t row = 0; row < before.rows(); ++row)
            if (row == 0 ||
                std::find(changing.begin(), changing.end(),
                          before.value(0, column)) == changing.end())
                CHECK(after.value(row, column) == before.value(row, column));
    return after;
}

}  // namespace

TEST_CASE("grades of an export go out into the platform's own table") {
    if (!has_sandbox()) return;
    const bool is_moodle = GENERATE(true, false);
    Download download(is_moodle ? moodle_export() : canvas_export());
    const CsvTable grades = graded(download, assignment_text);
    const CsvTable out =
        is_moodle
            ? filled(download, "--moodle", moodle_worksheet(),
                     {"Grade", "Feedback comments"})
            : filled(download, "--canvas", canvas_gradebook(), {"One (12)"});
    for (const MadeUp& one : made_up_class()) {
        CAPTURE(one.name());
        const bool is_there = one.kind != MadeUp::Kind::misnamed;
        const std::string total =
            is_moodle ? value(out, "Identifier",
                              fmt::format("Participant {}", moodle_number(one)),
                              "Grade")
                      : value(out, "ID", std::to_string(canvas_number(one)),
                              "One (12)");
        const bool is_empty = one.kind == MadeUp::Kind::empty;
        if (is_there) CHECK(std::stod("0" + total) == (is_empty ? 0 : 10));
    }
}
