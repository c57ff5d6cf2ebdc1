#include "grader/report/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "course/report/escape.h"
#include "course/report/explain.h"
#include "course/report/text.h"

namespace grader {

using course::escape_terminal;

namespace {

using course::CaseResult;
using course::Verdict;

constexpr std::size_t widest_name = 24;

// ---- a table of text: the first and the last column to the left

struct Cell {
    std::string text;
    std::string_view colour = "";  ///< what follows ESC[, or nothing
};
using Row = std::vector<Cell>;

std::string painted(const Cell& cell, Colour colour) {
    if (colour == Colour::off || cell.colour.empty()) return cell.text;
    return fmt::format("\x1b[{}{}\x1b[0m", cell.colour, cell.text);
}

std::vector<std::size_t> widths(const std::vector<Row>& rows) {
    std::vector<std::size_t> widest;
    for (const Row& row : rows) {
        widest.resize(std::max(widest.size(), row.size()));
        for (std::size_t k = 0; k < row.size(); ++k)
            widest[k] = std::max(widest[k], course::width(row[k].text));
    }
    return widest;
}

std::size_t table_width(const std::vector<Row>& rows) {
    std::size_t sum = 0;
    for (const std::size_t one : widths(rows)) sum += one + 2;
    return sum - std::min<std::size_t>(sum, 2);
}

std::string laid_out(const std::vector<Row>& rows, Colour colour) {
    const std::vector<std::size_t> widest = widths(rows);
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const std::string gap(widest[k] - course::width(row[k].text), ' ');
            const std::string cell = painted(row[k], colour);
            const bool left = k == 0 || k + 1 == widest.size();
            line += (k > 0 ? "  " : "") + (left ? cell + gap : gap + cell);
        }
        line.resize(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

// ---- the class

constexpr std::string_view bold = "1m";
constexpr std::string_view green = "32m";
constexpr std::string_view yellow = "33m";
constexpr std::string_view reversed = "7m";

std::string_view colour_of_verdict(Verdict verdict) {
    if (verdict == Verdict::accepted) return green;
    if (verdict == Verdict::not_submitted) return "";
    return verdict == Verdict::grader_fault ? reversed : yellow;
}

Cell exercise_cell(const std::optional<Score>& score) {
    if (!score) return {".."};
    std::string text(mark(score->verdict));
    if (shows_points(score)) text += " " + points_mark(*score);
    return {std::move(text), colour_of_verdict(score->verdict)};
}

Row ended_with_total(Row row, const ClassSummary& results,
                     const Scores& student) {
    const Total sum = total(results, student);
    row.push_back({sum.total ? course::points_text(*sum.total) : "-", bold});
    row.push_back(
        {sum.total ? course::percent_text(*sum.total, sum.max) : "-"});
    const std::string late = late_text(student);
    row.push_back({std::string(words(status(student))) +
                   (late.empty() ? "" : ", " + late)});
    return row;
}

Cell name_cell(const Student& student) {
    return {course::fitted(escape_terminal(shown_name(student)), widest_name)};
}

Row head(std::vector<std::string> names) {
    Row row = {{"student"}};
    for (std::string& name : names) row.push_back({std::move(name)});
    for (const char* last : {"total", "%", "status"}) row.push_back({last});
    for (Cell& cell : row) cell.colour = bold;
    return row;
}

Row foot(const ClassSummary& results, std::vector<std::string> maxima) {
    Row row = {{"out of"}};
    for (std::string& max : maxima) row.push_back({std::move(max)});
    row.push_back({course::points_text(max_total(results))});
    return row;
}

std::vector<Row> rows_by_exercise(const ClassSummary& results) {
    std::vector<std::string> names, maxima;
    for (std::size_t k = 0; k < results.exercises.size(); ++k) {
        names.emplace_back(short_name(results.exercises[k].exercise));
        maxima.push_back(course::points_text(max_points(results, k)));
    }
    std::vector<Row> rows = {head(names)};
    for (std::size_t k = 0; k < results.students.size(); ++k) {
        const Scores& scores = results.students[k];
        Row row = {name_cell(results.run.students[k])};
        for (const auto& score : scores) row.push_back(exercise_cell(score));
        rows.push_back(ended_with_total(std::move(row), results, scores));
    }
    rows.push_back(foot(results, maxima));
    return rows;
}

std::vector<std::string> chapters(const ClassSummary& results) {
    std::vector<std::string> names;
    for (const GradedExercise& one : results.exercises) {
        const std::string name(chapter(one.exercise));
        if (std::count(names.begin(), names.end(), name) == 0)
            names.push_back(name);
    }
    return names;
}

/// "2/5 31.5": how many exercises are right, and the points.
Cell chapter_cell(const ClassSummary& results, const Scores& student,
                  std::string_view name) {
    int all = 0, right = 0;
    double sum = 0;
    for (std::size_t k = 0; k < results.exercises.size(); ++k) {
        if (chapter(results.exercises[k].exercise) != name) continue;
        const auto& score = student[k];
        ++all;
        if (score && score->verdict == Verdict::accepted) ++right;
        sum += points(score).value_or(0);
    }
    return {fmt::format("{}/{} {}", right, all, course::points_text(sum)),
            right == all ? green : ""};
}

std::vector<Row> rows_by_chapter(const ClassSummary& results) {
    const std::vector<std::string> names = chapters(results);
    std::vector<std::string> maxima;
    for (const std::string& name : names) {
        double sum = 0;
        for (std::size_t k = 0; k < results.exercises.size(); ++k)
            if (chapter(results.exercises[k].exercise) == name)
                sum += max_points(results, k);
        maxima.push_back(course::points_text(sum));
    }
    std::vector<Row> rows = {head(names)};
    for (std::size_t k = 0; k < results.students.size(); ++k) {
        const Scores& scores = results.students[k];
        Row row = {name_cell(results.run.students[k])};
        for (const std::string& name : names)
            row.push_back(chapter_cell(results, scores, name));
        rows.push_back(ended_with_total(std::move(row), results, scores));
    }
    rows.push_back(foot(results, maxima));
    return rows;
}

/// The middle columns taken out: for many chapters, or a narrow terminal.
std::vector<Row> only_totals(std::vector<Row> rows, std::size_t middle) {
    for (Row& row : rows)
        row.erase(row.begin() + 1,
                  row.begin() + 1 + static_cast<std::ptrdiff_t>(middle));
    return rows;
}

std::string mark_legend(const ClassSummary& results) {
    std::string text;
    for (int k = 0; k <= static_cast<int>(Verdict::grader_fault); ++k) {
        const auto verdict = static_cast<Verdict>(k);
        text += fmt::format("{}{} {}", k % 5 > 0 ? ", " : (k > 0 ? "\n" : ""),
                            mark(verdict), words(verdict));
    }
    if (!results.by_hand.empty()) text += "\n* points set by hand";
    return text + "\n";
}

// ---- one student

/// Text of several lines, escaped, each line moved to the right.
std::string indented(std::string_view text, std::size_t columns) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines += std::string(columns, ' ') +
                 escape_terminal(text.substr(0, end)) + "\n";
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string case_text(const CaseResult& result, Colour colour) {
    const bool hidden = result.info.visibility == course::Visibility::hidden;
    std::string text = fmt::format("  {} {}{}  {} of {}\n",
                                   painted({std::string(mark(result.verdict)),
                                            colour_of_verdict(result.verdict)},
                                           colour),
                                   escape_terminal(result.info.name),
                                   hidden ? " (hidden)" : "",
                                   course::points_text(earned(result)),
                                   course::points_text(result.info.points));
    if (result.verdict != Verdict::accepted)
        text += indented(plain_text(result), 5);
    return text;
}

/// Of points that were set by hand: by whom, when and why.
std::string by_hand_text(const StudentResults& student, std::size_t k) {
    const auto set = student.by_hand.find(k);
    if (set == student.by_hand.end()) return "";
    const GradeByHand& grade = set->second;
    return fmt::format("  set by hand, {} by {}; the grader found {}: {}\n",
                       course::time_text(grade.set_at),
                       escape_terminal(grade.user),
                       course::points_text(student.exercises[k]->points()),
                       escape_terminal(grade.reason));
}

std::string exercise_text(const GradedAssignment& graded,
                          const StudentResults& student, std::size_t k,
                          Colour colour) {
    const auto& result = student.exercises[k];
    const std::string name(short_name(graded.exercises[k].exercise));
    if (!result) return fmt::format("\n{}: not judged yet\n", name);
    const auto value = points(score_of(student, k));
    std::string text =
        fmt::format("\n{}: {}, {} of {}\n", painted({name, bold}, colour),
                    painted({std::string(words(result->verdict)),
                             colour_of_verdict(result->verdict)},
                            colour),
                    value ? course::points_text(*value) : "-",
                    course::points_text(max_points(graded, k)));
    text += by_hand_text(student, k);
    text += indented(course::shortened(result->message, 8000, 60), 2);
    if (has_run(*result))
        for (const CaseResult& one : result->cases)
            text += case_text(one, colour);
    return text;
}

}  // namespace

Colour colour_of(int fd) {
    const char* no_colour = std::getenv("NO_COLOR");
    const char* kind = std::getenv("TERM");
    const bool wanted = no_colour == nullptr || *no_colour == '\0';
    const bool able = kind != nullptr && std::string_view(kind) != "dumb";
    return wanted && able && isatty(fd) == 1 ? Colour::on : Colour::off;
}

std::string class_table(const ClassSummary& results, Colour colour,
                        std::size_t columns) {
    const std::vector<Row> by_exercise = rows_by_exercise(results);
    if (table_width(by_exercise) <= columns)
        return laid_out(by_exercise, colour) + "\n" + mark_legend(results);
    const std::vector<Row> by_chapter = rows_by_chapter(results);
    if (table_width(by_chapter) <= columns)
        return laid_out(by_chapter, colour) +
               "\n2/5 31.5: 2 of 5 exercises are accepted, and there are 31.5 "
               "points\n";
    return laid_out(only_totals(by_chapter, chapters(results).size()), colour);
}

std::string student_text(const GradedAssignment& graded,
                         const StudentResults& student, Colour colour) {
    const Scores scores = scores_of(student);
    const Total sum = total(graded, scores);
    std::string text = fmt::format(
        "{} ({})\n{} of {} points, {} %, {}\n",
        painted({escape_terminal(shown_name(student.student)), bold}, colour),
        escape_terminal(student.student.id),
        sum.total ? course::points_text(*sum.total) : "-",
        course::points_text(sum.max),
        sum.total ? course::percent_text(*sum.total, sum.max) : "-",
        words(status(scores)));
    const std::string when = submitted_text(graded, student.student);
    if (!when.empty()) text += "handed in " + when + "\n";
    if (const std::string late = late_text(scores); !late.empty())
        text += late + "\n";
    for (const std::string& note : student.student.notes)
        text += "note: " + escape_terminal(note) + "\n";
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        text += exercise_text(graded, student, k, colour);
    return text;
}

}  // namespace grader
