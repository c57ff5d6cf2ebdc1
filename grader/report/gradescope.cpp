#include "grader/report/gradescope.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "course/report/explain.h"
#include "course/report/text.h"
#include "grader/report/escape.h"
#include "grader/report/feedback.h"

namespace grader {

namespace {

using Json = nlohmann::ordered_json;
using course::CaseResult;
using course::ExerciseResult;
using course::Verdict;

enum class Scores { with, without };

void add_score(Json& test, double score, double max, Scores scores) {
    if (scores == Scores::without) return;
    test["score"] = score;
    test["max_score"] = max;
}

Json test(const std::string& name, const std::string& number, Verdict verdict,
          const std::string& output) {
    Json one;
    one["name"] = escape_json(name);
    one["name_format"] = "text";
    one["number"] = number;
    one["status"] = verdict == Verdict::accepted ? "passed" : "failed";
    one["output"] = escape_json(output);
    one["output_format"] = "text";
    one["tags"] = {course::name(verdict)};
    one["visibility"] = "visible";
    return one;
}

Json case_test(const GradedExercise& exercise, const CaseResult& result,
               const std::string& number, Scores scores) {
    const std::string name(short_name(exercise.exercise));
    std::string output;
    if (result.verdict != Verdict::accepted)
        output =
            fmt::format("{}\n{}", words(result.verdict), plain_text(result));
    Json one =
        test(name + ": " + result.info.name, number, result.verdict, output);
    add_score(one, exercise.weight * earned(result),
              exercise.weight * result.info.points, scores);
    return one;
}

/// The file itself: its compiler messages, or that it is not there.
Json file_test(const GradedExercise& exercise, const ExerciseResult& result,
               const std::string& number) {
    const Verdict verdict = verdict_of_file(result);
    std::string output = course::shortened(result.message, 8000, 100);
    if (verdict != Verdict::accepted)
        output = fmt::format("{}\n{}", explanation(verdict), output);
    return test(std::string(short_name(exercise.exercise)), number, verdict,
                output);
}

void add_exercise(Json& tests, const ClassResults& results,
                  const StudentResults& student, std::size_t k, Scores scores) {
    if (!student.exercises[k]) return;
    const GradedExercise& exercise = results.exercises[k];
    const ExerciseResult shown =
        for_student(*student.exercises[k], results.assignment.hidden_feedback);
    const std::string number = std::to_string(k + 1);
    if (shown.cases.empty() || !shown.message.empty()) {
        Json file = file_test(exercise, shown, number);
        if (shown.cases.empty())  // otherwise they have the points
            add_score(file, 0, exercise.weight * exercise.suite.max, scores);
        tests.push_back(std::move(file));
    }
    for (std::size_t c = 0; c < shown.cases.size(); ++c)
        tests.push_back(case_test(exercise, shown.cases[c],
                                  fmt::format("{}.{}", number, c + 1), scores));
}

std::string output_text(const StudentResults& student) {
    std::string text = "Status: " + std::string(words(status(student)));
    for (const std::string& note : student.student.notes) text += "\n" + note;
    return text;
}

}  // namespace

std::string gradescope_json(const ClassResults& results,
                            const StudentResults& student) {
    const Total sum = total(results, student);
    const Scores scores = sum.total ? Scores::with : Scores::without;
    Json all;
    if (sum.total) all["score"] = *sum.total;
    all["output"] = escape_json(output_text(student));
    all["output_format"] = "text";
    all["visibility"] = "visible";
    all["stdout_visibility"] = "hidden";
    all["tests"] = Json::array();
    for (std::size_t k = 0; k < results.exercises.size(); ++k)
        add_exercise(all["tests"], results, student, k, scores);
    all["extra_data"] = {{"assignment", escape_json(results.assignment.name)},
                         {"student", escape_json(student.student.name)},
                         {"status", words(status(student))},
                         {"max", sum.max}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
