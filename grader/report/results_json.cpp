#include "grader/report/results_json.h"

#include <nlohmann/json.hpp>

#include "course/report/escape.h"
#include "course/report/explain.h"
#include "course/report/text.h"

namespace grader {

namespace {

using Json = nlohmann::ordered_json;
using course::escape_json;

std::string long_text(const std::string& text) {
    return escape_json(course::shortened(text, 8000, 100));
}

Json texts(const std::vector<std::string>& all) {
    Json list = Json::array();
    for (const std::string& one : all) list.push_back(escape_json(one));
    return list;
}

Json assignment_json(const GradedAssignment& graded) {
    Json exercises = Json::array();
    for (const GradedExercise& one : graded.exercises)
        exercises.push_back({{"exercise", one.exercise},
                             {"file", one.suite.file},
                             {"weight", one.weight},
                             {"is_bonus", one.is_bonus},
                             {"max", one.suite.max},
                             {"suite", one.suite.version}});
    return {{"name", escape_json(graded.assignment.name)},
            {"max", max_total(graded)},
            {"rounding", graded.assignment.rounding},
            {"exercises", exercises}};
}

Json run_json(const Run& run) {
    return {{"started_at", run.started_at},
            {"grader", run.version},
            {"sandbox", run.sandbox},
            {"seed", std::to_string(run.seed)},
            {"notes", texts(run.notes)}};
}

Json failure_json(const course::Failure& failure) {
    return {{"call", long_text(failure.call)},
            {"expected", long_text(failure.expected)},
            {"got", long_text(failure.got)},
            {"note", long_text(failure.note)},
            {"mesh", escape_json(failure.mesh.name)}};
}

Json case_json(const course::CaseResult& one) {
    Json failures = Json::array();
    for (const course::Failure& failure : one.failures)
        failures.push_back(failure_json(failure));
    return {{"name", one.info.name},
            {"is_hidden", one.info.visibility == course::Visibility::hidden},
            {"verdict", course::name(one.verdict)},
            {"points", earned(one)},
            {"max", one.info.points},
            {"hint", one.hint},
            {"printed", long_text(one.printed)},
            {"failures", failures}};
}

/// `score` is what counts; what the suite gave stands with the cases.
Json exercise_json(const GradedExercise& exercise,
                   const std::optional<Score>& score,
                   const std::optional<course::ExerciseResult>& result) {
    if (!score) return nullptr;
    Json cases = Json::array();
    if (result)
        for (const course::CaseResult& one : result->cases)
            cases.push_back(case_json(one));
    return {{"exercise", exercise.exercise},
            {"verdict", course::name(score->verdict)},
            {"points", score->points},
            {"is_set_by_hand", score->by_hand},
            {"max", exercise.suite.max},
            {"message", result ? long_text(result->message) : ""},
            {"cases", cases}};
}

Json people_json(const Student& student) {
    Json people = Json::array();
    for (const Member& one : people_of(student))
        people.push_back({{"name", escape_json(one.name)},
                          {"number", escape_json(one.number)},
                          {"email", escape_json(one.email)}});
    return people;
}

Json student_json(const GradedAssignment& graded,
                  const StudentResults& results) {
    const Scores scores = scores_of(results);
    const Total sum = total(graded, scores);
    Json student = {{"id", results.student.id},
                    {"name", escape_json(results.student.name)},
                    {"people", people_json(results.student)},
                    {"status", words(status(scores))},
                    {"max", sum.max},
                    {"days_late", scores.late.days},
                    {"late_cost", sum.late_cost},
                    {"notes", texts(results.student.notes)},
                    {"exercises", Json::array()}};
    if (sum.total) student["total"] = *sum.total;
    if (results.student.submitted_at)
        student["submitted_at"] = *results.student.submitted_at;
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        student["exercises"].push_back(exercise_json(
            graded.exercises[k], scores[k], results.exercises[k]));
    return student;
}

std::string dumped(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string results_json(const Gradebook& gradebook,
                         const Assignment& assignment) {
    const GradedAssignment graded = graded_assignment(gradebook, assignment);
    std::string text =
        "{\"format\": \"half-edge course results\",\n"
        "\"version\": 1,\n\"assignment\": " +
        dumped(assignment_json(graded)) +
        ",\n\"run\": " + dumped(run_json(graded.run)) + ",\n\"students\": [";
    // One at a time: as objects they take many times the memory of their text.
    for (const Student& student : graded.run.students) {
        if (&student != graded.run.students.data()) text += ",";
        text +=
            "\n" + dumped(student_json(
                       graded, student_results(gradebook, graded, student)));
    }
    return text + "]}\n";
}

}  // namespace grader
