#include "grader/report/grades_csv.h"

#include "course/report/text.h"
#include "grader/report/escape.h"

namespace grader {

namespace {

std::string cell(const std::optional<course::ExerciseResult>& result) {
    const auto value = points(result);
    return value ? course::points_text(*value) : "";
}

std::string line(const ClassResults& results, const StudentResults& student) {
    const Total sum = total(results, student);
    std::string text = escape_csv(student.student.name);
    text += "," + (sum.total ? course::points_text(*sum.total) : "");
    text += "," + course::points_text(sum.max);
    text += "," + (sum.total ? course::percent_text(*sum.total, sum.max) : "");
    text += "," + std::string(words(status(student)));
    for (const auto& result : student.exercises) text += "," + cell(result);
    return text + "\n";
}

}  // namespace

std::string grades_csv(const ClassResults& results) {
    std::string text = "student,total,max,percent,status";
    for (const GradedExercise& one : results.exercises)
        text += "," + escape_csv(short_name(one.exercise));
    text += "\n";
    for (const StudentResults& student : results.students)
        text += line(results, student);
    return text;
}

}  // namespace grader
