#include "course/cli/explain_result.h"

#include <fmt/format.h>

#include "course/halfedge/describe.h"
#include "course/report/explain.h"
#include "course/report/text.h"

namespace course {

namespace {

std::string indented(const std::string& text, const std::string& margin) {
    std::string result = margin;
    for (const char c : text) {
        result += c;
        if (c == '\n') result += margin;
    }
    while (!result.empty() && (result.back() == ' ' || result.back() == '\n'))
        result.pop_back();
    return result + "\n";
}

/// The table that the failed call walked on, with the rows of its walk marked.
std::string table_of(const Failure& failure) {
    if (failure.mesh.rows.empty()) return "";
    std::vector<int> marked;
    for (const Visit& visit : failure.walk) marked.push_back(visit.i);
    return fmt::format(
        "\n  The table of mesh \"{}\"{}:\n{}", failure.mesh.name,
        marked.empty() ? "" : ", > where the call looked",
        indented(describe(HalfEdgeTable(failure.mesh.rows), marked), "    "));
}

std::string failed_case(const Exercise& exercise, const CaseResult& c) {
    std::string text = fmt::format("\n{}: {}\n", words(c.verdict), c.info.name);
    CaseResult first = c;
    if (first.failures.size() > 1) first.failures.resize(1);
    text += indented(visible(plain_text(first)), "  ");
    if (!c.failures.empty()) text += table_of(c.failures[0]);
    text += fmt::format("\n  More help: ./course/lab hint {}\n", exercise.name);
    return text;
}

std::string case_lines(const ExerciseResult& result) {
    std::string text;
    for (const CaseResult& c : result.cases)
        text += fmt::format("  {:<6} {}{}\n",
                            c.verdict == Verdict::accepted ? "ok" : "FAILED",
                            c.info.name,
                            c.verdict == Verdict::accepted
                                ? ""
                                : fmt::format("  ({})", words(c.verdict)));
    return text;
}

}  // namespace

std::string explain_result(const Exercise& exercise,
                           const std::filesystem::path& file,
                           const ExerciseResult& result) {
    std::string text =
        fmt::format("{}: {}\n\n", file.string(), words(result.verdict));
    if (!result.message.empty())
        text += indented(visible(result.message), "  ") + "\n";
    if (result.verdict == Verdict::compile_error ||
        result.verdict == Verdict::grader_fault)
        return text;
    text += case_lines(result);
    for (const CaseResult& c : result.cases)
        if (c.verdict != Verdict::accepted) {
            text += failed_case(exercise, c);
            break;
        }
    text += fmt::format(
        "\n{} of {} points of the public cases. Grading runs more cases. The "
        "file ran\nunder the limits of grading, but without a sandbox.\n",
        points_text(result.points()), points_text(result.max()));
    return text;
}

}  // namespace course
