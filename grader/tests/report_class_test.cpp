// From the gradebook to the numbers of a class.
#include "grader/report/class_results.h"

#include <array>

#include "course/runner/codec.h"
#include "course/runner/temporary_folder.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

/// The sample class with one student, who has these results.
ClassResults one_student(Results results) {
    ClassResults all = sample_class();
    all.students = {{all.run.students[0], std::move(results)}};
    return all;
}

Status status_of(const Results& results) {
    return status(scores_of(one_student(results).students[0]));
}

}  // namespace

TEST_CASE("a class from the gradebook gives the reports of the class itself") {
    const course::TemporaryFolder folder;
    const ClassResults sample = sample_class();
    Gradebook book(folder / "g.sqlite");
    record(book, sample);
    const ClassSummary read =
        write_reports(book, sample.assignment, folder / "out");
    const ClassResults sorted = class_results(book, sample.assignment);
    REQUIRE(sorted.students.size() == sample.students.size());
    CHECK((class_page(read).text == class_page(summary_of(sorted)).text));
    CHECK((grades_csv(read) == grades_csv(summary_of(sorted))));
    for (const StudentResults& student : sample.students)
        CHECK((student_page(read, student_results(book, read, student.student))
                   .text == student_page(sample, student).text));
}

TEST_CASE("students stand in the order of the names that are shown") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    Run run = sample_run();
    run.students.clear();
    for (const auto& [id, name, person] :
         std::vector<std::array<std::string, 3>>{{"Zoe", "Zoe", ""},
                                                 {"a", "a", "Mia Rossi"},
                                                 {"anna", "anna", ""},
                                                 {"b2", "b", "mia rossi"},
                                                 {"b1", "b", "Mia rossi"},
                                                 {"cmd", "=cmd", ""},
                                                 {"Bea", "Bea", ""}}) {
        run.students.push_back({id, name, {}});
        run.students.back().person = person;
    }
    book.begin_run(run);
    std::string order;
    for (const Student& one :
         graded_assignment(book, sample_assignment()).run.students)
        order += one.id + " ";
    CHECK(order == "cmd anna Bea a b1 b2 Zoe ");
}

TEST_CASE("an exercise without a result is not judged, and has no total") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    book.begin_run(sample_run());
    const ClassSummary read =
        write_reports(book, sample_assignment(), folder / "out");
    REQUIRE(read.students.size() == 5);
    CHECK((status(read.students[0]) == Status::not_judged));
    CHECK_FALSE(total(read, read.students[0]).total.has_value());
    CHECK(total(read, read.students[0]).max == 35);
    CHECK_THAT(grades_csv(read), Containing("anna.rossi,,35,,not judged,,,\n"));
    const StudentResults anna =
        student_results(book, read, read.run.students[0]);
    CHECK_THAT(student_page(read, anna).text, Containing("Not judged yet."));
    CHECK_THAT(class_table(read, Colour::off), Containing(".."));
}

TEST_CASE("a gradebook without a run has no students") {
    const course::TemporaryFolder folder;
    const Gradebook book(folder / "g.sqlite");
    const ClassSummary read =
        write_reports(book, sample_assignment(), folder / "out");
    CHECK(read.students.empty());
    CHECK_THAT(class_page(read).text, Containing("No student"));
    CHECK(grades_csv(read) ==
          "student,total,max,percent,status,face_sides,vertex_star,"
          "boundary_walk\n");
    CHECK_FALSE(class_table(read, Colour::off).empty());
}

TEST_CASE("points are weighted, and what is missing counts nothing") {
    const ClassResults all =
        one_student({all_accepted()[0], wrong_and_endless()[1], nothing()[2]});
    const Total sum = total(all, scores_of(all.students[0]));
    CHECK(sum.total == 10 + 1.5 * 5);
    CHECK(sum.max == 10 + 1.5 * 10 + 10);
}

TEST_CASE("bonus adds to the total and not to its maximum") {
    ClassResults all = one_student(all_accepted());
    all.exercises[2].is_bonus = true;
    all.assignment.rounding = 10;
    const Total sum = total(all, scores_of(all.students[0]));
    CHECK(sum.total == 40);  // 10 + 1.5 * 10 + 10, halves upwards
    CHECK(sum.max == 10 + 1.5 * 10);
    CHECK_THAT(class_page(summary_of(all)).text, Containing("1 (bonus)"));
}

TEST_CASE("the status tells what a total is worth") {
    const auto ok = all_accepted()[0], none = nothing()[0], broken = fault()[0],
               wrong = wrong_and_endless()[2];
    CHECK((status_of({ok, ok, ok}) == Status::complete));
    CHECK((status_of({ok, wrong, wrong}) == Status::complete));
    CHECK((status_of({ok, none, ok}) == Status::partial));
    CHECK((status_of({none, none, none}) == Status::nothing_submitted));
    CHECK((status_of({none, broken, std::nullopt}) == Status::grader_fault));
    CHECK((status_of({ok, none, std::nullopt}) == Status::not_judged));
}

TEST_CASE("a grader fault never becomes a grade") {
    const ClassResults all = one_student(fault());
    CHECK_FALSE(total(all, scores_of(all.students[0])).total.has_value());
    CHECK_THAT(grades_csv(summary_of(all)),
               Containing("anna.rossi,,35,,grader fault,,7,0\n"));
    const std::string json = gradescope_json(all, all.students[0]);
    CHECK(json.find("\"score\"") == json.npos);
    CHECK_THAT(student_page(all, all.students[0]).text,
               Containing("no grade yet"));
}

TEST_CASE("the cases that fail most come first, of those that could run") {
    const auto failed = most_failed(summary_of(sample_class()));
    REQUIRE(failed.size() == 7);
    CHECK(failed[0].exercise == "01_traversal/vertex_star");
    CHECK(failed[0].name == "the faces of the slide mesh");
    CHECK(failed[0].failed == 2);
    CHECK(failed[0].judged == 4);
    // boundary_walk: one compile error, one forbidden operation, one right.
    CHECK(failed[6].exercise == "02_border/boundary_walk");
    CHECK(failed[6].failed == 1);
    CHECK(failed[6].judged == 2);
}

TEST_CASE("a student is found by id, or by the name of the folder") {
    const std::vector<Student> all = sample_run().students;
    CHECK(find_student(all, "carla") == &all[3]);
    CHECK(find_student(all, "=cmd|' /C calc'!A0") == &all[2]);
    CHECK(find_student(all, all[1].id) == &all[1]);
    CHECK(find_student(all, "nobody") == nullptr);
}
