#include "grader/report/junit.h"

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>

#include "course/report/escape.h"
#include "course/report/explain.h"
#include "course/report/text.h"
#include "grader/report/feedback.h"

namespace grader {

using course::escape_xml;

namespace {

using course::CaseResult;
using course::ExerciseResult;
using course::Verdict;

/// One testcase element, before its text is escaped.
struct TestCase {
    std::string name;
    Verdict verdict = Verdict::grader_fault;
    std::string text;
};

/// What readers of the format know of a verdict.
std::string_view element(Verdict verdict) {
    if (verdict == Verdict::wrong_answer) return "failure";
    return verdict == Verdict::not_submitted ? "skipped" : "error";
}

std::vector<TestCase> test_cases(const ExerciseResult& result) {
    std::vector<TestCase> all;
    // Compiler messages belong to no case.
    if (result.cases.empty() || !result.message.empty())
        all.push_back({"the file as a whole", verdict_of_file(result),
                       course::shortened(result.message, 8000, 100)});
    for (const CaseResult& one : result.cases)
        all.push_back({one.info.name, one.verdict, plain_text(one)});
    std::map<std::string, int> times;
    for (TestCase& one : all)
        if (const int n = ++times[one.name]; n > 1)
            one.name += fmt::format(" ({})", n);
    return all;
}

int count(const std::vector<TestCase>& all, std::string_view kind) {
    int n = 0;
    for (const TestCase& one : all)
        if (one.verdict != Verdict::accepted && element(one.verdict) == kind)
            ++n;
    return n;
}

std::string outcome(const TestCase& one) {
    if (one.verdict == Verdict::accepted)
        return one.text.empty() ? ""
                                : fmt::format("<system-out>{}</system-out>",
                                              escape_xml(one.text));
    const std::string_view kind = element(one.verdict);
    if (kind == "skipped") return "<skipped message=\"not submitted\"/>";
    return fmt::format(R"(<{} message="{}" type="{}">{}</{}>)", kind,
                       escape_xml(words(one.verdict)), name(one.verdict),
                       escape_xml(one.text), kind);
}

std::string test_case_xml(const GradedExercise& exercise, const TestCase& one) {
    return fmt::format(
        R"(    <testcase classname="{}" name="{}" file="{}" time="0">{})"
        "</testcase>\n",
        escape_xml(short_name(exercise.exercise)), escape_xml(one.name),
        escape_xml(exercise.suite.file), outcome(one));
}

std::string suite_xml(const GradedExercise& exercise,
                      const ExerciseResult& result) {
    const std::vector<TestCase> all = test_cases(result);
    std::string text = fmt::format(
        R"(  <testsuite name="{}" tests="{}" failures="{}" errors="{}" )"
        R"(skipped="{}" time="0">)"
        "\n",
        escape_xml(short_name(exercise.exercise)), all.size(),
        count(all, "failure"), count(all, "error"), count(all, "skipped"));
    for (const TestCase& one : all) text += test_case_xml(exercise, one);
    return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const GradedAssignment& graded,
                      const StudentResults& student) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        if (const auto& result = student.exercises[k])
            text += suite_xml(graded.exercises[k],
                              for_student(*result, hidden_feedback(graded)));
    return text + "</testsuites>\n";
}

}  // namespace grader
