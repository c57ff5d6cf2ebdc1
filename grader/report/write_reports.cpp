#include "grader/report/write_reports.h"

#include "course/mesh/file_defects.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/junit.h"
#include "grader/report/student_page.h"

namespace grader {

void write_reports(const ClassResults& results,
                   const std::filesystem::path& out) {
    for (const StudentResults& student : results.students) {
        const auto folder = out / "students" / student.student.id;
        std::filesystem::create_directories(folder);
        course::replace_text(folder / "feedback.html",
                             student_page(results, student).text);
        course::replace_text(folder / "results.json",
                             gradescope_json(results, student));
        course::replace_text(folder / "junit.xml", junit_xml(results, student));
    }
    // Last: whoever sees these two sees all that they lead to.
    std::filesystem::create_directories(out);
    course::replace_text(out / "grades.csv", grades_csv(results));
    course::replace_text(out / "report.html", class_page(results).text);
}

}  // namespace grader
