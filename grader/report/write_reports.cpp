#include "grader/report/write_reports.h"

#include <fstream>

#include "course/mesh/file_defects.h"
#include "grader/report/class_page.h"
#include "grader/report/grades_csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/junit.h"
#include "grader/report/student_page.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

/// Whether a regular file has these bytes. Nothing else is opened: reading from
/// a pipe would never end.
bool holds(const fs::path& file, std::string_view text) {
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(file, error)) ||
        fs::file_size(file, error) != text.size())
        return false;
    std::ifstream in(file, std::ios::binary);
    std::vector<char> block(1 << 14);
    while (!text.empty()) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        const std::string_view found(block.data(),
                                     static_cast<std::size_t>(in.gcount()));
        if (found.empty() || !text.starts_with(found)) return false;
        text.remove_prefix(found.size());
    }
    return true;
}

/// Nearly all students' files of a second run are those of the first.
void write(const fs::path& file, std::string_view text) {
    if (!holds(file, text)) course::replace_text(file, text);
}

void write_student(const GradedAssignment& graded,
                   const StudentResults& student, const fs::path& folder) {
    fs::create_directories(folder);
    write(folder / "feedback.html", student_page(graded, student).text);
    write(folder / "results.json", gradescope_json(graded, student));
    write(folder / "junit.xml", junit_xml(graded, student));
}

}  // namespace

ClassSummary write_reports(const Gradebook& gradebook,
                           const Assignment& assignment, const fs::path& out) {
    ClassSummary all{graded_assignment(gradebook, assignment), {}, {}, {}};
    for (const Student& student : all.run.students) {
        const StudentResults results = student_results(gradebook, all, student);
        write_student(all, results, out / "students" / student.id);
        add(all, results);
        add_history(all, gradebook.history(student.id));
    }
    // Last: whoever sees these two sees all that they lead to.
    fs::create_directories(out);
    course::replace_text(out / "grades.csv", grades_csv(all));
    course::replace_text(out / "report.html", class_page(all).text);
    return all;
}

}  // namespace grader
