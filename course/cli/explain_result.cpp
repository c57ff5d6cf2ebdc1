#include "course/cli/explain_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "course/halfedge/describe.h"
#include "course/report/compiler_messages.h"
#include "course/report/explain.h"
#include "course/report/mesh_text.h"
#include "course/report/text.h"

namespace course {

namespace {

// The drawing stands right of the table; together they fit into 80 columns.
constexpr int drawing_columns = 48;
constexpr int drawing_lines = 18;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string indented(const std::string& text, const std::string& margin) {
    std::string result;
    for (const std::string& line : lines_of(text))
        result += (line.empty() ? "" : margin + line) + "\n";
    while (!result.empty() && (result.back() == ' ' || result.back() == '\n'))
        result.pop_back();
    return result + "\n";
}

/// Two texts side by side.
std::string beside(const std::string& left, const std::string& right) {
    const std::vector<std::string> a = lines_of(left), b = lines_of(right);
    std::size_t columns = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        columns = std::max(columns, width(a[k]));
    std::string text;
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
        std::string line = k < a.size() ? a[k] : "";
        if (k < b.size() && !b[k].empty())
            line += std::string(columns + 2 - width(line), ' ') + b[k];
        text += line + "\n";
    }
    return text;
}

/// The table that the failed call walked on, with the rows of its walk marked,
/// and the mesh where a drawing helps.
std::string table_of(const Failure& failure) {
    if (failure.mesh.rows.empty()) return "";
    std::vector<int> marked;
    for (const Visit& visit : failure.walk) marked.push_back(visit.i);
    const std::string table =
        describe(HalfEdgeTable(failure.mesh.rows), marked);
    const std::string drawing = mesh_text(failure.mesh, walk_of(failure),
                                          drawing_columns, drawing_lines);
    return fmt::format("\n  The table of mesh \"{}\"{}:\n{}", failure.mesh.name,
                       marked.empty() ? "" : ", > where the call looked",
                       indented(beside(table, drawing), "    "));
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
        text += indented(visible(explain_compiler(result.message)), "") + "\n";
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
