#include "course/cli/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "course/report/text.h"

namespace course {

namespace {

constexpr std::size_t tab = 4;

std::string without_tabs(std::string_view line) {
    std::string plain;
    for (const char c : line)
        if (c == '\t')
            plain += std::string(tab, ' ');
        else
            plain += c;
    return plain;
}

/// Bytes of the longest head that fits; of one character at least.
std::size_t size_of_head(std::string_view line, std::size_t columns) {
    std::size_t end = 0, used = 0;
    while (end < line.size()) {
        const Piece piece = first_piece(line.substr(end));
        used += width(piece.bytes);
        if (used > columns && end > 0) break;
        end += piece.bytes.size();
    }
    return end;
}

/// Breaks one line; the indentation is kept, as far as it leaves some room.
void wrap_line(std::string line, std::size_t columns,
               std::vector<std::string>& to) {
    const std::size_t blanks =
        std::min(line.find_first_not_of(' '), line.size());
    const std::string margin(std::min(blanks, columns / 3), ' ');
    while (width(line) > columns) {
        const std::size_t fits = size_of_head(line, columns);
        const std::size_t space = line.rfind(' ', fits);
        const bool has_words =
            space != std::string::npos && space > margin.size();
        const std::size_t end = has_words ? space : fits;
        to.push_back(line.substr(0, end));
        const std::size_t rest = line.find_first_not_of(' ', end);
        line.erase(0, std::min(rest, line.size()));
        if (!line.empty()) line.insert(0, margin);
    }
    to.push_back(std::move(line));
}

/// What a line begins with, behind its blanks, and the colour for it.
struct Style {
    std::string_view start, code;
};

constexpr std::string_view red = "\033[1;31m", green = "\033[1;32m",
                           amber = "\033[33m", bold = "\033[1m",
                           cyan = "\033[36m";

constexpr std::array<Style, 14> styles = {{
    {"ok ", green},
    {"FAILED ", red},
    {"accepted", green},
    {"wrong answer", red},
    {"run-time error", red},
    {"time limit exceeded", red},
    {"memory limit exceeded", red},
    {"compile error", red},
    {"grader fault", red},
    {"expected ", bold},
    {"got ", bold},
    {"-> ", cyan},
    {"Hint: ", cyan},
    {">", amber},
}};

std::string painted(const std::string& line, std::size_t begin,
                    std::size_t size, std::string_view code) {
    return fmt::format("{}{}{}\033[0m{}", line.substr(0, begin), code,
                       line.substr(begin, size), line.substr(begin + size));
}

/// "file.cpp:8:19: error: ..." and the last line of a compile.
std::string coloured_message(const std::string& line) {
    for (const auto& [word, code] :
         {std::pair(std::string_view(": error: "), red),
          std::pair(std::string_view(": warning: "), amber)})
        if (const auto at = line.find(word); at != std::string::npos)
            return painted(line, at + 2, word.size() - 3, code);
    return line;
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        wrap_line(without_tabs(text.substr(0, end)), columns, lines);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::vector<std::string> in_two_columns(const std::vector<std::string>& left,
                                        const std::vector<std::string>& right,
                                        std::size_t columns) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k) {
        const std::string a = k < left.size() ? left[k] : "";
        const std::string b = k < right.size() ? right[k] : "";
        lines.push_back(
            coloured(a) +
            std::string(columns - std::min(columns, width(a)), ' ') + " │ " +
            coloured(b));
    }
    return lines;
}

std::string coloured(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) return line;
    const std::string_view rest = std::string_view(line).substr(begin);
    for (const Style& style : styles)
        if (rest.starts_with(style.start)) {
            const bool whole = style.code == amber || style.code == cyan;
            return painted(line, begin,
                           whole ? rest.size() : style.start.size(),
                           style.code);
        }
    return coloured_message(line);
}

std::vector<std::string> screen_of(const Page& page, ScreenSize size,
                                   std::size_t& top) {
    std::vector<std::string> lines = page.head;
    const std::size_t taken = std::min(lines.size() + 2, size.lines);
    const std::size_t room = std::max<std::size_t>(size.lines - taken, 1);
    const std::size_t all = page.body.size();
    top = std::min(top, all > room ? all - room : 0);
    for (std::size_t k = top; k < std::min(all, top + room); ++k)
        lines.push_back(coloured(page.body[k]));
    while (lines.size() < page.head.size() + room) lines.emplace_back();
    const std::size_t below = all - std::min(all, top + room);
    lines.push_back(below > 0 ? fmt::format("\033[2m-- {} more lines: space{}",
                                            below, top > 0 ? "; back: b" : "")
                    : top > 0 ? "\033[2m-- the end; back: b"
                              : "");
    lines.push_back("\033[7m" + fitted(page.foot, size.columns) + "\033[0m");
    if (lines.size() > size.lines)
        lines.erase(lines.begin(),
                    lines.end() - static_cast<std::ptrdiff_t>(size.lines));
    return lines;
}

}  // namespace course
