// Late work and teams in every report.
#include "course/report/text.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The sample class with its first student handing in at that time.
ClassResults handed_in(const std::string& when) {
    ClassResults all = sample_class();
    all.assignment.due = {instant_of("2026-12-11T22:59:00Z"), "Europe/Rome"};
    all.assignment.late = {LatePolicy::Kind::percent_per_day, 10, 10, 1, 5};
    StudentResults& anna = all.students[0];
    anna.student.submitted_at = when;
    anna.late =
        lateness(*all.assignment.due, all.assignment.late, instant_of(when));
    all.run.students[0] = anna.student;
    return all;
}

}  // namespace

// 35 points: 10, 10 times 1.5, 10. Due 23:59 in Rome, ten minutes of grace, the
// first day free, 10 % for each further one, nothing after the fifth.
TEST_CASE("what counts of late work, computed by hand") {
    struct Row {
        const char* when;
        const char* total;
        const char* late;
    };
    for (const Row& row :
         {Row{"2026-12-11T23:09:00Z", "35", ""},
          Row{"2026-12-11T23:09:01Z", "35", "1 day late"},
          Row{"2026-12-13T23:09:00Z", "31.5", "2 days late, 90 % counts"},
          Row{"2026-12-16T23:09:00Z", "21", "5 days late, 60 % counts"},
          Row{"2026-12-16T23:09:01Z", "0", "6 days late, 0 % counts"}}) {
        CAPTURE(row.when);
        const ClassSummary all = summary_of(handed_in(row.when));
        CHECK(late_text(all.students[0]) == row.late);
        CHECK(course::points_text(total(all, all.students[0]).total.value()) ==
              row.total);
    }
}

TEST_CASE("every report says what lateness costs") {
    const ClassResults all = handed_in("2026-12-13T23:09:00Z");
    const ClassSummary sums = summary_of(all);
    const std::string text = "2 days late, 90 % counts";
    CHECK(has(class_page(sums).text, "<br><small>" + text));
    CHECK(has(class_table(sums, Colour::off, 300), text));
    CHECK(has(grades_csv(sums), ",submitted,late\n"));
    CHECK(has(grades_csv(sums), ",2026-12-13T23:09:00Z,\"" + text + "\"\n"));
    const std::string page = student_page(all, all.students[0]).text;
    CHECK(has(page, "2026-12-14 00:09 CET: " + text + " (3.5 points less)"));
    CHECK(has(student_text(all, all.students[0], Colour::off), text));
    const std::string json = gradescope_json(all, all.students[0]);
    CHECK(has(json, text));
    CHECK(has(json, "\"score\": 31.5"));
}

TEST_CASE("each member of a team has a line with the result of all") {
    ClassResults all = sample_class();
    Student& team = all.students[0].student;
    team.person = "Anna, =B";
    team.members = {{"Anna <b>", "1", "a@example.org"}, {"=B", "2", ""}};
    all.run.students[0] = team;
    const ClassSummary sums = summary_of(all);
    const std::string csv = grades_csv(sums);
    CHECK(has(csv, ",Anna <b>,1,a@example.org\n"));
    CHECK(has(csv, ",\"'=B\",2,\n"));
    const std::string page = class_page(sums).text;
    CHECK(has(page, "<bdi>Anna &lt;b&gt;</bdi>"));
    CHECK(has(page, "<bdi>=B</bdi>"));
}

TEST_CASE("a mark of the platform is shown where no time is known") {
    ClassResults all = sample_class();
    all.students[0].student.marked_late = true;
    const ClassSummary sums = summary_of(all);
    CHECK(late_text(sums.students[0]) == "marked as late by the platform");
    CHECK(total(sums, sums.students[0]).total == 35);
    CHECK(has(grades_csv(sums), ",marked as late by the platform\n"));
}
