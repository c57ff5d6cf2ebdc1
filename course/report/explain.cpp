#include "course/report/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "course/report/text.h"

namespace course {

namespace {

constexpr std::size_t most_lines = 8;

std::string plain_text(const Failure& failure) {
    std::string text = shortened(failure.call, 600, 10) + "\n";
    const auto add = [&](std::string_view label, const std::string& value) {
        if (!value.empty())
            text +=
                fmt::format("  {:<9} {}\n", label, shortened(value, 600, 10));
    };
    add("expected", failure.expected);
    add("got", failure.got);
    add("mesh", failure.mesh.name);
    add("walk", walk_text(walk_of(failure)));
    add("lines", lines_of(failure));
    add("note", failure.note);
    return text;
}

}  // namespace

std::string_view explanation(Verdict verdict) {
    constexpr std::array<std::string_view, 9> sentences = {
        "Every case passed.",
        "It runs to the end, but some answers are not the expected ones.",
        "It stopped with an error in at least one case.",
        "It asked for more memory than a call may have.",
        "It did not end within its limits of time and of reads: a walk that "
        "never comes back to its start, or far more reads than needed.",
        "It does not compile. The compiler says why:",
        "It tried something that the sandbox forbids.",
        "It was not handed in.",
        "The grader could not judge it. That is not your mistake, and there is "
        "no grade for it yet.",
    };
    return sentences.at(static_cast<std::size_t>(verdict));
}

bool has_run(const course::ExerciseResult& result) {
    return result.verdict <= Verdict::time_limit_exceeded ||
           result.verdict == Verdict::forbidden_operation;
}

Verdict verdict_of_file(const course::ExerciseResult& result) {
    return has_run(result) ? Verdict::accepted : result.verdict;
}

double earned(const CaseResult& result) {
    return result.verdict == Verdict::accepted ? result.info.points : 0;
}

Walk walk_of(const Failure& failure) {
    return walk_of(failure.walk, failure.reads);
}

std::string lines_of(const Failure& failure) {
    std::vector<int> lines;
    for (const Visit& visit : failure.walk)
        if (visit.line > 0 && lines.size() < most_lines &&
            std::count(lines.begin(), lines.end(), visit.line) == 0)
            lines.push_back(visit.line);
    return fmt::format("{}", fmt::join(lines, ", "));
}

std::string plain_text(const CaseResult& result) {
    std::string text;
    if (!result.hint.empty()) text += "Hint: " + result.hint + "\n";
    for (const Failure& failure : result.failures) text += plain_text(failure);
    if (!result.printed.empty())
        text += "It printed:\n" + shortened(result.printed, 2000, 30) + "\n";
    return text;
}

}  // namespace course
