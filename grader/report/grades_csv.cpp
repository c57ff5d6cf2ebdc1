#include "grader/report/grades_csv.h"

#include <algorithm>

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

/// Which columns there are beside those that every table has.
struct Columns {
    bool by_hand, times, late, people;
};

Columns columns_of(const ClassSummary& results) {
    const auto& all = results.run.students;
    const auto has = [&](auto test) {
        return std::any_of(all.begin(), all.end(), test);
    };
    return {!results.by_hand.empty(),
            has([](const Student& s) { return s.submitted_at.has_value(); }),
            results.assignment.due || has_late(results.students),
            has([](const Student& s) { return !s.person.empty(); })};
}

/// What all members of a submission share.
std::string line(const ClassSummary& results, std::size_t student,
                 const Columns& columns) {
    const Scores& scores = results.students[student];
    const Total sum = total(results, scores);
    std::string text = escape_csv(results.run.students[student].name);
    text += "," + (sum.total ? course::points_text(*sum.total) : "");
    text += "," + course::points_text(sum.max);
    text += "," + (sum.total ? course::percent_text(*sum.total, sum.max) : "");
    text += "," + std::string(words(status(scores)));
    for (const auto& score : scores) text += "," + cell(score);
    const Student& facts = results.run.students[student];
    if (columns.by_hand) text += "," + escape_csv(by_hand(results, student));
    if (columns.times) text += "," + facts.submitted_at.value_or("");
    if (columns.late) text += "," + escape_csv(late_text(scores));
    return text;
}

std::string lines(const ClassSummary& results, std::size_t student,
                  const Columns& columns) {
    const std::string shared = line(results, student, columns);
    if (!columns.people) return shared + "\n";
    std::string text;
    for (const Member& one : people_of(results.run.students[student]))
        text += shared + "," + escape_csv(one.name) + "," +
                escape_csv(one.number) + "," + escape_csv(one.email) + "\n";
    return text;
}

}  // namespace

std::string grades_csv(const ClassSummary& results) {
    std::string text = "student,total,max,percent,status";
    for (const GradedExercise& one : results.exercises)
        text += "," + escape_csv(short_name(one.exercise));
    const Columns columns = columns_of(results);
    if (columns.by_hand) text += ",set by hand";
    if (columns.times) text += ",submitted";
    if (columns.late) text += ",late";
    if (columns.people) text += ",name,number,email";
    text += "\n";
    for (std::size_t k = 0; k < results.students.size(); ++k)
        text += lines(results, k, columns);
    return text;
}

}  // namespace grader
