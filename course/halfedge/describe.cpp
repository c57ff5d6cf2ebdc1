// Writing a half-edge table for people to read.
#include "course/halfedge/describe.h"

#include <fmt/format.h>

#include <algorithm>

namespace course {

namespace {

using Rows = std::vector<HalfEdge>;

constexpr int rows_at_each_end = 24;

bool has_row(const Rows& rows, int i) {
    return i >= 0 && static_cast<std::size_t>(i) < rows.size();
}

const HalfEdge& at(const Rows& rows, int i) {
    return rows[static_cast<std::size_t>(i)];
}

/// Of all rows, the numbers of one field that are 0 or more, each once.
std::size_t distinct(const Rows& rows, int HalfEdge::*field) {
    std::vector<int> numbers;
    for (const HalfEdge& row : rows)
        if (row.*field >= 0) numbers.push_back(row.*field);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers.size();
}

/// Follows the border from i and marks it; true when it comes back to i.
bool is_border_loop(const Rows& rows, int start, std::vector<bool>& met) {
    int i = start;
    while (has_row(rows, i) && at(rows, i).fi == -1 &&
           !met[static_cast<std::size_t>(i)]) {
        met[static_cast<std::size_t>(i)] = true;
        i = at(rows, i).next;
    }
    return i == start;
}

std::size_t border_loops(const Rows& rows) {
    std::vector<bool> met(rows.size(), false);
    std::size_t loops = 0;
    for (int i = 0; has_row(rows, i); ++i)
        if (at(rows, i).fi == -1 && !met[static_cast<std::size_t>(i)] &&
            is_border_loop(rows, i, met))
            ++loops;
    return loops;
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string counts(const Rows& rows) {
    return fmt::format(
        "{}, {}, {}, {}\n",
        counted(distinct(rows, &HalfEdge::vi), "vertex", "vertices"),
        counted(rows.size() / 2, "edge", "edges"),
        counted(distinct(rows, &HalfEdge::fi), "face", "faces"),
        counted(border_loops(rows), "border loop", "border loops"));
}

std::string cell(int number) {
    return number == -1 ? "-" : fmt::format("{}", number);
}

/// The cells of one line; a single one is a remark across the columns.
using Line = std::vector<std::string>;

Line line_of(const Rows& rows, int i, const char* mark) {
    const HalfEdge& row = at(rows, i);
    return {fmt::format("{}{}", mark, i), cell(row.vi), cell(row.fi),
            cell(row.next), cell(row.opp)};
}

std::string aligned(const std::vector<Line>& lines) {
    std::vector<std::size_t> widths(lines[0].size(), 0);
    for (const Line& line : lines)
        for (std::size_t k = 0; line.size() > 1 && k < line.size(); ++k)
            widths[k] = std::max(widths[k], line[k].size());
    std::string text;
    for (const Line& line : lines) {
        for (std::size_t k = 0; k < line.size(); ++k)
            text += fmt::format("{}{:>{}}", k == 0 ? "" : "  ", line[k],
                                line.size() > 1 ? widths[k] : 0);
        text += "\n";
    }
    return text;
}

}  // namespace

std::string describe(const HalfEdgeTable& he) {
    return describe(he, {});
}

std::string describe(const HalfEdgeTable& he, const std::vector<int>& marked) {
    const Rows& rows = he.rows();
    std::vector<bool> is_marked(rows.size(), false);
    for (const int i : marked)
        if (has_row(rows, i)) is_marked[static_cast<std::size_t>(i)] = true;
    std::vector<Line> lines = {{"", "vi", "fi", "next", "opp"}};
    std::size_t left_out = 0;
    for (int i = 0; i < he.size(); ++i) {
        const bool is_here = is_marked[static_cast<std::size_t>(i)];
        if (!is_here && i >= rows_at_each_end &&
            i < he.size() - rows_at_each_end) {
            ++left_out;
            continue;
        }
        if (left_out > 0)
            lines.push_back({fmt::format("... {} left out",
                                         counted(left_out, "row", "rows"))});
        left_out = 0;
        lines.push_back(line_of(rows, i, is_here ? ">" : ""));
    }
    return aligned(lines) + counts(rows);
}

}  // namespace course
