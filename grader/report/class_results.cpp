#include "grader/report/class_results.h"

#include <algorithm>
#include <array>

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

StudentResults results_of(const Gradebook& gradebook,
                          const Assignment& assignment,
                          const Student& student) {
    StudentResults results{student, {}};
    for (const Assignment::Item& item : assignment.exercises) {
        auto attempt = gradebook.latest(student.id, item.exercise);
        results.exercises.push_back(
            attempt ? std::optional(std::move(attempt->result)) : std::nullopt);
    }
    return results;
}

bool is_fault(const std::optional<ExerciseResult>& result) {
    return result && result->verdict == Verdict::grader_fault;
}

bool is_missing(const std::optional<ExerciseResult>& result) {
    return result && result->verdict == Verdict::not_submitted;
}

}  // namespace

ClassResults class_results(const Gradebook& gradebook,
                           const Assignment& assignment) {
    ClassResults results;
    results.assignment = assignment;
    results.run = gradebook.last_run().value_or(Run());
    for (const Assignment::Item& item : assignment.exercises)
        results.exercises.push_back(
            {item.exercise, item.weight, suite_of(results.run, item.exercise)});
    for (const Student& student : results.run.students)
        results.students.push_back(results_of(gradebook, assignment, student));
    return results;
}

std::string_view words(Status status) {
    constexpr std::array<std::string_view, 5> all = {
        "grader fault", "not judged", "nothing submitted", "partial",
        "complete"};
    return all.at(static_cast<std::size_t>(status));
}

Status status(const StudentResults& student) {
    const auto& all = student.exercises;
    if (std::any_of(all.begin(), all.end(), is_fault))
        return Status::grader_fault;
    if (!std::all_of(all.begin(), all.end(),
                     [](const auto& result) { return result.has_value(); }))
        return Status::not_judged;
    if (std::all_of(all.begin(), all.end(), is_missing))
        return Status::nothing_submitted;
    if (std::any_of(all.begin(), all.end(), is_missing)) return Status::partial;
    return Status::complete;
}

Total total(const ClassResults& results, const StudentResults& student) {
    Total sum;
    double sum_of_points = 0;
    for (std::size_t k = 0; k < results.exercises.size(); ++k) {
        const double weight = results.exercises[k].weight;
        sum.max += weight * max_points(results, k);
        sum_of_points += weight * points(student.exercises[k]).value_or(0);
    }
    const Status now = status(student);
    if (now != Status::grader_fault && now != Status::not_judged)
        sum.total = sum_of_points;
    return sum;
}

double max_points(const ClassResults& results, std::size_t exercise) {
    return results.exercises[exercise].suite.max;
}

std::optional<double> points(const std::optional<ExerciseResult>& result) {
    if (!result || is_fault(result)) return std::nullopt;
    return result->points();
}

bool is_weighted(const ClassResults& results) {
    return std::any_of(
        results.exercises.begin(), results.exercises.end(),
        [](const GradedExercise& one) { return one.weight != 1; });
}

bool was_judged(const std::optional<ExerciseResult>& result) {
    return result && !is_fault(result) && !is_missing(result);
}

const StudentResults* find_student(const ClassResults& results,
                                   std::string_view id_or_name) {
    for (const StudentResults& one : results.students)
        if (one.student.id == id_or_name) return &one;
    for (const StudentResults& one : results.students)
        if (one.student.name == id_or_name) return &one;
    return nullptr;
}

std::string_view mark(Verdict verdict) {
    constexpr std::array<std::string_view, 9> marks = {
        "ok", "WA", "RE", "ML", "TL", "CE", "FO", "--", "!!"};
    return marks.at(static_cast<std::size_t>(verdict));
}

}  // namespace grader
