#include "grader/report/gradescope.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "course/report/escape.h"
#include "course/report/explain.h"
#include "course/report/text.h"
#include "grader/report/feedback.h"

namespace grader {

using course::escape_json;

namespace {

using Json = nlohmann::ordered_json;
using course::CaseResult;
using course::ExerciseResult;
using course::Verdict;

/// Without a grade nothing has a score, so that none can be taken for one.
enum class Grade { given, none };

void add_score(Json& test, double score, double max, Grade grade) {
    if (grade == Grade::none) return;
    test["score"] = score;
    test["max_score"] = max;
}

Json test(const std::string& name, const std::string& number, Verdict verdict,
          const std::string& output) {
    Json one = Json::object();
    // Else each new member would copy those before it.
    one.get_ref<Json::object_t&>().reserve(10);
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

/// What so many points of it add to the maximum.
double worth(const GradedExercise& exercise, double points) {
    return exercise.is_bonus ? 0 : exercise.weight * points;
}

Json case_test(const GradedExercise& exercise, const CaseResult& result,
               const std::string& number, Grade grade) {
    const std::string name(short_name(exercise.exercise));
    std::string output;
    if (result.verdict != Verdict::accepted)
        output =
            fmt::format("{}\n{}", words(result.verdict), plain_text(result));
    Json one =
        test(name + ": " + result.info.name, number, result.verdict, output);
    add_score(one, exercise.weight * earned(result),
              worth(exercise, result.info.points), grade);
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

void add_exercise(Json& tests, const GradedAssignment& graded,
                  const StudentResults& student, std::size_t k, Grade grade) {
    if (!student.exercises[k]) return;
    const GradedExercise& exercise = graded.exercises[k];
    const ExerciseResult shown =
        for_student(*student.exercises[k], hidden_feedback(graded));
    const std::string number = std::to_string(k + 1);
    if (shown.cases.empty() || !shown.message.empty()) {
        Json file = file_test(exercise, shown, number);
        if (shown.cases.empty())  // otherwise they have the points
            add_score(file, 0, worth(exercise, exercise.suite.max), grade);
        tests.push_back(std::move(file));
    }
    for (std::size_t c = 0; c < shown.cases.size(); ++c)
        tests.push_back(case_test(exercise, shown.cases[c],
                                  fmt::format("{}.{}", number, c + 1), grade));
}

std::string output_text(const GradedAssignment& graded,
                        const StudentResults& student, Status now) {
    std::string text = "Status: " + std::string(words(now));
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        if (const auto score = score_of(student, k); score && score->by_hand)
            text += fmt::format("\n{}: the points were set by hand: {} of {}",
                                short_name(graded.exercises[k].exercise),
                                course::points_text(score->points),
                                course::points_text(max_points(graded, k)));
    if (const std::string late = late_text(scores_of(student)); !late.empty())
        text += "\n" + late;
    for (const std::string& note : student.student.notes) text += "\n" + note;
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        if (const std::string sentence =
                mistake_for_student(graded, student, k);
            !sentence.empty())
            text += fmt::format(
                "\n{}: {}", short_name(graded.exercises[k].exercise), sentence);
    return text;
}

}  // namespace

std::string gradescope_json(const GradedAssignment& graded,
                            const StudentResults& student) {
    const Scores scores = scores_of(student);
    const Total sum = total(graded, scores);
    const Grade grade = sum.total ? Grade::given : Grade::none;
    Json all;
    if (sum.total) all["score"] = *sum.total;
    all["output"] = escape_json(output_text(graded, student, status(scores)));
    all["output_format"] = "text";
    all["visibility"] = "visible";
    all["stdout_visibility"] = "hidden";
    all["tests"] = Json::array();
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        add_exercise(all["tests"], graded, student, k, grade);
    all["extra_data"] = {{"assignment", escape_json(graded.assignment.name)},
                         {"student", escape_json(student.student.name)},
                         {"status", words(status(scores))},
                         {"max", sum.max}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
