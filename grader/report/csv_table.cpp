#include "grader/report/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "course/mesh/ascii.h"
#include "course/report/text.h"

namespace grader {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '_';
}

std::string quoted(std::string_view value) {
    std::string text = "\"";
    for (const char c : value) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

}  // namespace

/// Finds the cells of a text for one separator.
class CsvTable::Reader {
public:
    Reader(const std::string& text, char separator)
        : text_(text),
          separator_(separator),
          end_of_row_(text.find('\n') == text.npos ? '\r' : '\n') {
        if (text.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    }

    /// All rows, as wide as the first.
    std::vector<Row> table() {
        std::vector<Row> rows;
        while (at_ < text_.size()) {
            Row row = next_row();
            const bool is_blank_line =
                row.cells.size() == 1 && row.cells[0].begin == row.cells[0].end;
            if (is_blank_line) continue;
            rows.push_back(std::move(row));
            require_as_wide(rows.back(), rows[0]);
        }
        if (rows.empty()) throw CsvError("the table is empty");
        return rows;
    }

private:
    static void require_as_wide(const Row& row, const Row& header) {
        if (row.cells.size() != header.cells.size())
            throw CsvError(
                fmt::format("line {}: {} cells, expected {} as in the header",
                            row.line, row.cells.size(), header.cells.size()));
    }

    Row next_row() {
        Row row{line_, {}};
        for (;;) {
            row.cells.push_back(next_cell());
            if (at_ == text_.size()) return row;
            const char c = text_[at_++];
            if (c == separator_) continue;
            if (c == '\r' && end_of_row_ == '\n') ++at_;  // CRLF
            ++line_;
            return row;
        }
    }

    bool ends_row(std::size_t at) const {
        return text_[at] == end_of_row_ ||
               (text_[at] == '\r' && at + 1 < text_.size() &&
                text_[at + 1] == '\n');
    }

    Cell next_cell() {
        const std::size_t begin = at_;
        if (at_ < text_.size() && text_[at_] == '"')
            pass_quoted();
        else
            while (at_ < text_.size() && text_[at_] != separator_ &&
                   !ends_row(at_))
                ++at_;
        return {begin, at_};
    }

    void pass_quoted() {
        const int begin = line_;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == end_of_row_) ++line_;
            if (text_[at_] != '"') continue;
            ++at_;
            if (at_ == text_.size() || text_[at_] == separator_ ||
                ends_row(at_))
                return;
            if (text_[at_] != '"')
                throw CsvError(fmt::format(
                    "line {}: something stands behind a closing quote", line_));
        }
        throw CsvError(fmt::format(
            "line {}: a quote begins there and does not end", begin));
    }

    const std::string& text_;
    char separator_, end_of_row_;
    std::size_t at_ = 0;
    int line_ = 1;
};

CsvTable::CsvTable(std::string text) : text_(std::move(text)) {
    if (text_.find('\0') != text_.npos)
        throw CsvError("not a table in UTF-8: it has bytes that are 0");
    std::optional<CsvError> first;
    for (const char separator : {',', ';', '\t'}) {
        try {
            std::vector<Row> rows = Reader(text_, separator).table();
            if (!rows_.empty() && rows[0].cells.size() <= columns()) continue;
            rows_ = std::move(rows);
            separator_ = separator;
        } catch (const CsvError& error) {
            if (!first) first = error;
        }
    }
    if (rows_.empty() || (columns() == 1 && first)) throw CsvError(*first);
}

std::string CsvTable::value(std::size_t row, std::size_t column) const {
    const Cell cell = rows_.at(row).cells.at(column);
    const std::string_view raw =
        std::string_view(text_).substr(cell.begin, cell.end - cell.begin);
    if (!raw.starts_with('"')) return std::string(raw);
    std::string value;
    for (std::size_t k = 1; k + 1 < raw.size(); ++k) {
        value += raw[k];
        if (raw[k] == '"') ++k;
    }
    return value;
}

void CsvTable::set(std::size_t row, std::size_t column,
                   std::string_view value) {
    const Cell cell = rows_.at(row).cells.at(column);
    const bool was_quoted = cell.begin < cell.end && text_[cell.begin] == '"';
    const std::string special = std::string("\"\r\n") + separator_;
    const bool must_be = value.find_first_of(special) != value.npos;
    replaced_[cell.begin] = {
        cell.end, was_quoted || must_be ? quoted(value) : std::string(value)};
}

std::string CsvTable::text() const {
    std::string text;
    std::size_t at = 0;
    for (const auto& [begin, instead] : replaced_) {
        text.append(text_, at, begin - at);
        text += instead.second;
        at = instead.first;
    }
    return text + text_.substr(at);
}

std::optional<std::size_t> column_named(const CsvTable& table,
                                        std::string_view name) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < table.columns(); ++k) {
        if (plain_name(table.value(0, k)) != plain_name(name)) continue;
        if (found)
            throw CsvError(fmt::format("two columns are named \"{}\"", name));
        found = k;
    }
    return found;
}

std::optional<double> number_in(std::string_view text) {
    std::string digits = plain_name(text);
    std::replace(digits.begin(), digits.end(), ',', '.');
    double number = 0;
    const char* end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || rest != end || !std::isfinite(number))
        return std::nullopt;
    return number;
}

Decimal decimal_of(const CsvTable& table,
                   const std::vector<std::size_t>& columns) {
    for (std::size_t row = 1; row < table.rows(); ++row)
        for (const std::size_t column : columns) {
            const std::string text = table.value(row, column);
            if (!number_in(text)) continue;
            if (text.find('.') != text.npos) return Decimal::point;
            if (text.find(',') != text.npos) return Decimal::comma;
        }
    return table.separator() == ';' ? Decimal::comma : Decimal::point;
}

std::string number_text(double number, Decimal decimal) {
    std::string text = course::points_text(number);
    if (decimal == Decimal::comma)
        std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

std::string plain_name(std::string_view name) {
    std::string plain;
    for (const char c : name) {
        if (!is_blank(c))
            plain += course::ascii_lower(c);
        else if (!plain.empty() && plain.back() != ' ')
            plain += ' ';
    }
    if (plain.ends_with(' ')) plain.pop_back();
    return plain;
}

}  // namespace grader
