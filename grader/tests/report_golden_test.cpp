// What people and other systems read, compared with copies that were looked
// at.
#include "course/runner/temporary_folder.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/junit.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

TEST_CASE("the class's reports are as in the golden files") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    record(book, sample_class());
    const ClassSummary results =
        write_reports(book, sample_assignment(), folder / "out");
    check_golden("grades.csv", grades_csv(results));
    check_golden("report.html", class_page(results).text);
    check_golden("class_table.txt", class_table(results, Colour::off));
    check_golden("class_table_by_chapter.txt",
                 class_table(results, Colour::off, 95));
    check_golden("class_table_colour.txt", class_table(results, Colour::on));
}

TEST_CASE("the students' reports are as in the golden files") {
    const ClassResults results = sample_class();
    for (std::size_t k = 0; k < results.students.size(); ++k) {
        const StudentResults& student = results.students[k];
        const std::string number = std::to_string(k + 1);
        check_golden("feedback_" + number + ".html",
                     student_page(results, student).text);
        check_golden("results_" + number + ".json",
                     gradescope_json(results, student));
        check_golden("junit_" + number + ".xml", junit_xml(results, student));
        check_golden("show_" + number + ".txt",
                     student_text(results, student, Colour::off));
    }
}
