// The parser goes on after a defect, so that one message holds them all. It
// looks at views of the text and copies only the little that it quotes.
#include "course/runner/table_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace course {

namespace {

constexpr std::size_t largest_text = std::size_t{1} << 20;
constexpr std::size_t most_defects = 20;
constexpr std::size_t longest_quote = 40;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view header = "half_edge,vi,fi,next,opp";
constexpr std::array<std::string_view, 5> columns = {"half_edge", "vi", "fi",
                                                     "next", "opp"};

using Cell = std::optional<int>;
using Row = std::vector<Cell>;

/// What was found, safe to print: short, and in printable ASCII only.
std::string quoted(std::string_view found) {
    if (found.empty()) return "nothing";
    std::string text;
    for (const char c : found.substr(0, longest_quote)) {
        if (c >= ' ' && c <= '~')
            text += c;
        else
            text += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    }
    return fmt::format("\"{}{}\"", text,
                       found.size() > longest_quote ? "..." : "");
}

/// The defects seen so far: the first few in words, the others only counted.
class Defects {
public:
    void add(std::string_view where, std::string_view found,
             std::string_view expected) {
        if (count_ < most_defects)
            text_ += fmt::format("\n{}: found {}, expected {}", where, found,
                                 expected);
        ++count_;
    }

    /// Throws CsvError when there are any.
    void raise() const {
        if (count_ == 0) return;
        std::string message = "the file is not a half-edge table:" + text_;
        if (count_ > most_defects)
            message += fmt::format("\nand {} more", count_ - most_defects);
        throw CsvError(message);
    }

private:
    std::size_t count_ = 0;
    std::string text_;
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The parts of `text` between the separators; at least one.
std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    std::size_t end = text.find(separator);
    while (end != std::string_view::npos) {
        parts.push_back(trimmed(text.substr(0, end)));
        text.remove_prefix(end + 1);
        end = text.find(separator);
    }
    parts.push_back(trimmed(text));
    return parts;
}

/// The number that all of `text` says, if it says one.
Cell number(std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

Cell parse_cell(std::string_view text, const std::string& where,
                Defects& defects) {
    if (text.empty()) return std::nullopt;
    if (text == "-") return -1;
    const Cell value = number(text);
    if (!value)
        defects.add(where, quoted(text),
                    "a whole number, the plain sign - for none, or nothing");
    return value;
}

Row parse_row(std::string_view text, int line, Defects& defects) {
    const std::vector<std::string_view> cells = split(text, ',');
    Row row;
    if (cells.size() != columns.size()) {
        defects.add(
            fmt::format("line {}", line),
            fmt::format("{} {} in {}", cells.size(),
                        cells.size() == 1 ? "cell" : "cells", quoted(text)),
            fmt::format("{} with commas between them", columns.size()));
        return row;
    }
    for (std::size_t k = 0; k < columns.size(); ++k)
        row.push_back(parse_cell(
            cells[k], fmt::format("line {}, {}", line, columns[k]), defects));
    return row;
}

bool is_header(std::string_view text) {
    const std::vector<std::string_view> cells = split(text, ',');
    return std::equal(cells.begin(), cells.end(), columns.begin(),
                      columns.end());
}

}  // namespace

std::vector<std::vector<std::optional<int>>> parse_table_csv(
    std::string_view text) {
    if (text.size() > largest_text)
        throw CsvError(
            fmt::format("the file is not a half-edge table:\nline 1: found {} "
                        "bytes in the file, expected at most {}",
                        text.size(), largest_text));
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
        text.remove_prefix(byte_order_mark.size());
    Defects defects;
    std::vector<Row> rows;
    bool header_seen = false;
    int line = 0;
    for (const std::string_view content : split(text, '\n')) {
        ++line;
        if (content.empty() || content.front() == '#') continue;
        if (header_seen) {
            rows.push_back(parse_row(content, line, defects));
        } else if (!is_header(content)) {
            defects.add(fmt::format("line {}", line), quoted(content), header);
        }
        header_seen = true;
    }
    if (!header_seen)
        defects.add(fmt::format("line {}", line), "the end of the file",
                    header);
    defects.raise();
    return rows;
}

}  // namespace course
