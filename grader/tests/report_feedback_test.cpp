// What students may read: in each file that they get, at each level.
#include "grader/report/feedback.h"

#include "course/runner/codec.h"
#include "grader/report/class_page.h"
#include "grader/report/gradescope.h"
#include "grader/report/junit.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

constexpr const char* hint_of_hidden = "Which of your steps relies";

/// All that a student gets.
std::string given_to(const ClassResults& results,
                     const StudentResults& student) {
    return student_page(results, student).text +
           gradescope_json(results, student) + junit_xml(results, student);
}

std::string given_to_all(FeedbackLevel level) {
    ClassResults results = sample_class();
    results.assignment.hidden_feedback = {level, level};
    std::string all;
    for (const StudentResults& student : results.students)
        all += given_to(results, student);
    return all;
}

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != text.npos;
}

}  // namespace

TEST_CASE("nothing of a hidden case but name and hint reaches a student") {
    const std::string all = given_to_all(FeedbackLevel::names_and_hints);
    CHECK_FALSE(contains(all, "SECRET"));
    CHECK(contains(all, hint_of_hidden));
    CHECK(contains(all, "the numbering does not matter"));
}

TEST_CASE("at the level of names the hints of hidden cases stay hidden too") {
    const std::string all = given_to_all(FeedbackLevel::names);
    CHECK_FALSE(contains(all, "SECRET"));
    CHECK_FALSE(contains(all, hint_of_hidden));
    CHECK(contains(all, "the numbering does not matter"));
    CHECK(contains(all, "What do you count"));  // of a public case
}

TEST_CASE("at the level full everything is shown but the grader's faults") {
    const std::string all = given_to_all(FeedbackLevel::full);
    for (const char* what :
         {"call", "expected", "got", "note", "mesh", "print"})
        CHECK(contains(all, std::string("SECRET ") + what));
    CHECK_FALSE(contains(all, "SECRET fault"));
}

TEST_CASE("a shown case keeps everything at every level") {
    const ExerciseResult whole = *wrong_and_endless()[1];
    for (const auto level :
         {FeedbackLevel::names, FeedbackLevel::names_and_hints,
          FeedbackLevel::full}) {
        const ExerciseResult shown = for_student(whole, level);
        CHECK(
            (course::encode(shown.cases[0]) == course::encode(whole.cases[0])));
        CHECK(shown.points() == whole.points());
        CHECK(shown.max() == whole.max());
    }
}

TEST_CASE("the compiler's words are cut down as in lab, in every file") {
    ClassResults results = sample_class();
    StudentResults& student = results.students[1];
    student.exercises[1]->message =
        "In file included from SECRET.h:1,\n"
        "                 from vertex_star.cpp:1:\n"
        "vertex_star.cpp: In function 'int f()':\n"
        "vertex_star.cpp:4:9: warning: unused variable 'vi'\n"
        "    4 |     int vi;\n      |         ^~\n"
        "/usr/include/SECRET.h:4:9: note: declared here\n";
    for (const std::string& text :
         {student_page(results, student).text,
          gradescope_json(results, student), junit_xml(results, student)}) {
        CHECK_FALSE(contains(text, "SECRET.h"));
        CHECK(contains(text, "vertex_star.cpp:4:9: warning: unused variable"));
        CHECK(contains(text, "The variable is never looked at"));
    }
    CHECK_THAT(student_text(results, student, Colour::off),
               Containing("SECRET.h"));
}

TEST_CASE("the instructor sees what the grader's fault was") {
    const ClassResults results = sample_class();
    CHECK_THAT(class_page(summary_of(results)).text,
               Containing("SECRET fault"));
    CHECK_THAT(student_text(results, results.students[4], Colour::off),
               Containing("SECRET fault"));
    CHECK_THAT(student_text(results, results.students[1], Colour::off),
               Containing("SECRET call"));
}
