#include "grader/report/grades_csv.h"

#include "course/report/escape.h"
#include "course/report/text.h"

namespace grader {

using course::escape_csv;

namespace {

std::string cell(const std::optional<Score>& score) {
    const auto value = points(score);
    return value ? course::points_text(*value) : "";
}

/// "face_sides: oral exam; prev: typing mistake", or nothing.
std::string by_hand(const ClassSummary& results, std::size_t student) {
    std::string text;
    for (const SetPoints& set : results.by_hand) {
        if (set.student != student) continue;
        if (!text.empty()) text += "; ";
        text += short_name(results.exercises[set.exercise].exercise);
        text += ": " + set.grade.reason;
    }
    return text;
}

std::string line(const ClassSummary& results, std::size_t student) {
    const Scores& scores = results.students[student];
    const Total sum = total(results, scores);
    std::string text = escape_csv(results.run.students[student].name);
    text += "," + (sum.total ? course::points_text(*sum.total) : "");
    text += "," + course::points_text(sum.max);
    text += "," + (sum.total ? course::percent_text(*sum.total, sum.max) : "");
    text += "," + std::string(words(status(scores)));
    for (const auto& score : scores) text += "," + cell(score);
    if (!results.by_hand.empty())
        text += "," + escape_csv(by_hand(results, student));
    return text + "\n";
}

}  // namespace

std::string grades_csv(const ClassSummary& results) {
    std::string text = "student,total,max,percent,status";
    for (const GradedExercise& one : results.exercises)
        text += "," + escape_csv(short_name(one.exercise));
    text += results.by_hand.empty() ? "\n" : ",set by hand\n";
    for (std::size_t k = 0; k < results.students.size(); ++k)
        text += line(results, k);
    return text;
}

}  // namespace grader
