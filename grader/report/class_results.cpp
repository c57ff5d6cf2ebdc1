#include "grader/report/class_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "course/mesh/ascii.h"
#include "course/report/text.h"

namespace grader {

namespace {

using course::ExerciseResult;
using course::Verdict;

/// The suite that the run used; one without points if it used none.
Suite suite_of(const Run& run, const std::string& exercise) {
    for (const Suite& suite : run.suites)
        if (suite.exercise == exercise) return suite;
    return {exercise, std::string(short_name(exercise)), "", 0};
}

bool is_fault(const std::optional<Score>& score) {
    return score && score->verdict == Verdict::grader_fault && !score->by_hand;
}

bool is_missing(const std::optional<Score>& score) {
    return score && score->verdict == Verdict::not_submitted;
}

/// By the names that people look for, large and small letters alike.
void sort_by_name(std::vector<Student>& students) {
    const auto place = [](const Student& one) {
        return std::pair(course::ascii_lower(shown_name(one)), one.id);
    };
    std::sort(students.begin(), students.end(),
              [&](const Student& a, const Student& b) {
                  return place(a) < place(b);
              });
}

}  // namespace

GradedAssignment graded_assignment(const Gradebook& gradebook,
                                   const Assignment& assignment) {
    GradedAssignment graded;
    graded.assignment = assignment;
    graded.run = gradebook.last_run().value_or(Run());
    sort_by_name(graded.run.students);
    graded.mistakes = gradebook.mistakes();
    for (const Assignment::Item& item : assignment.exercises)
        graded.exercises.push_back({item.exercise, item.weight,
                                    suite_of(graded.run, item.exercise),
                                    item.is_bonus});
    return graded;
}

FeedbackLevel hidden_feedback(const GradedAssignment& graded) {
    const std::string& started_at = graded.run.started_at;
    if (started_at.empty()) return graded.assignment.hidden_feedback.before_due;
    return hidden_feedback_at(graded.assignment, instant_of(started_at));
}

StudentResults student_results(const Gradebook& gradebook,
                               const GradedAssignment& graded,
                               const Student& student) {
    std::map<std::string, ExerciseResult> latest;
    for (Attempt& attempt : gradebook.latest(student.id))
        latest[attempt.exercise] = std::move(attempt.result);
    StudentResults results{student, {}};
    const Assignment& assignment = graded.assignment;
    if (assignment.due && student.submitted_at)
        results.late = lateness(*assignment.due, assignment.late,
                                instant_of(*student.submitted_at));
    for (const GradedExercise& one : graded.exercises) {
        const auto found = latest.find(one.exercise);
        results.exercises.emplace_back();
        if (found != latest.end())
            results.exercises.back() = std::move(found->second);
    }
    for (const GradeByHand& grade : gradebook.set_by_hand(student.id))
        for (std::size_t k = 0; k < graded.exercises.size(); ++k)
            if (graded.exercises[k].exercise == grade.exercise)
                results.by_hand.emplace(k, grade);
    return results;
}

std::optional<Score> score_of(const StudentResults& student, std::size_t k) {
    const auto& result = student.exercises[k];
    if (!result) return std::nullopt;
    Score score{result->verdict, result->points()};
    if (const auto set = student.by_hand.find(k);
        set != student.by_hand.end()) {
        score.points = set->second.points.value_or(score.points);
        score.by_hand = true;
    }
    return score;
}

Scores scores_of(const StudentResults& student) {
    Scores scores;
    scores.late = student.late;
    scores.marked_late = student.student.marked_late;
    for (std::size_t k = 0; k < student.exercises.size(); ++k)
        scores.push_back(score_of(student, k));
    return scores;
}

std::string_view words(Status status) {
    constexpr std::array<std::string_view, 5> all = {
        "grader fault", "not judged", "nothing submitted", "partial",
        "complete"};
    return all.at(static_cast<std::size_t>(status));
}

Status status(const Scores& student) {
    if (std::any_of(student.begin(), student.end(), is_fault))
        return Status::grader_fault;
    if (!std::all_of(student.begin(), student.end(),
                     [](const auto& score) { return score.has_value(); }))
        return Status::not_judged;
    if (std::all_of(student.begin(), student.end(), is_missing))
        return Status::nothing_submitted;
    if (std::any_of(student.begin(), student.end(), is_missing))
        return Status::partial;
    return Status::complete;
}

Total total(const GradedAssignment& graded, const Scores& student) {
    double sum = 0;
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        sum += graded.exercises[k].weight * points(student[k]).value_or(0);
    const Status now = status(student);
    const bool is_grade =
        now != Status::grader_fault && now != Status::not_judged;
    const double counts = student.late.factor * sum;
    const double step = graded.assignment.rounding;
    return {is_grade ? std::optional(rounded(counts, step)) : std::nullopt,
            max_total(graded), sum - counts};
}

std::string late_text(const Scores& student) {
    const Lateness& late = student.late;
    if (late.days == 0)
        return student.marked_late ? "marked as late by the platform" : "";
    std::string text =
        late.days == 1 ? "1 day late" : fmt::format("{} days late", late.days);
    if (late.factor < 1)
        text += fmt::format(", {} % counts",
                            course::points_text(100 * late.factor));
    return text;
}

std::string submitted_text(const GradedAssignment& graded,
                           const Student& student) {
    if (!student.submitted_at) return "";
    const auto& due = graded.assignment.due;
    return text_in(instant_of(*student.submitted_at), due ? due->zone : "UTC");
}

bool has_late(const std::vector<Scores>& students) {
    return std::any_of(students.begin(), students.end(), [](const Scores& one) {
        return one.late.days > 0 || one.marked_late;
    });
}

const std::string& shown_name(const Student& student) {
    return student.person.empty() ? student.name : student.person;
}

std::vector<Member> people_of(const Student& student) {
    if (!student.members.empty()) return student.members;
    return {{shown_name(student), student.key, ""}};
}

double max_total(const GradedAssignment& graded) {
    double sum = 0;
    for (const GradedExercise& one : graded.exercises)
        if (!one.is_bonus) sum += one.weight * one.suite.max;
    return sum;
}

double max_points(const GradedAssignment& graded, std::size_t exercise) {
    return graded.exercises[exercise].suite.max;
}

std::optional<double> points(const std::optional<Score>& score) {
    if (!score || is_fault(score)) return std::nullopt;
    return score->points;
}

bool is_weighted(const GradedAssignment& graded) {
    return std::any_of(graded.exercises.begin(), graded.exercises.end(),
                       [](const GradedExercise& one) {
                           return one.weight != 1 || one.is_bonus;
                       });
}

std::string weight_text(const GradedExercise& exercise) {
    return course::points_text(exercise.weight) +
           (exercise.is_bonus ? " (bonus)" : "");
}

bool was_judged(const std::optional<Score>& score) {
    return score && !is_fault(score) && !is_missing(score);
}

std::string points_mark(const Score& score) {
    return course::points_text(score.points) + (score.by_hand ? "*" : "");
}

bool shows_points(const std::optional<Score>& score) {
    return was_judged(score) || (score && score->by_hand);
}

const Student* find_student(const std::vector<Student>& students,
                            std::string_view id_or_name) {
    for (const Student& one : students)
        if (one.id == id_or_name) return &one;
    for (const Student& one : students)
        if (one.name == id_or_name) return &one;
    for (const Student& one : students)
        if (!id_or_name.empty() &&
            (one.person == id_or_name || one.key == id_or_name))
            return &one;
    return nullptr;
}

std::string_view mark(Verdict verdict) {
    constexpr std::array<std::string_view, 9> marks = {
        "ok", "WA", "RE", "ML", "TL", "CE", "FO", "--", "!!"};
    return marks.at(static_cast<std::size_t>(verdict));
}

ClassResults class_results(const Gradebook& gradebook,
                           const Assignment& assignment) {
    ClassResults results{graded_assignment(gradebook, assignment), {}};
    for (const Student& student : results.run.students)
        results.students.push_back(
            student_results(gradebook, results, student));
    return results;
}

bool was_judged(const std::optional<ExerciseResult>& result) {
    return result && was_judged(std::optional(Score{result->verdict, 0}));
}

}  // namespace grader
