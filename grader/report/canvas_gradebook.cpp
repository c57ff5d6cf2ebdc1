#include "grader/report/canvas_gradebook.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "course/report/escape.h"
#include "course/report/text.h"

namespace grader {

namespace {

using Column = std::optional<std::size_t>;

/// The surest first.
constexpr std::array<std::string_view, 4> id_headers = {
    "ID", "SIS User ID", "SIS Login ID", "Integration ID"};

/// "First light (4711)" taken apart; no number in other headers.
struct AssignmentHeader {
    std::string name, number;
};

AssignmentHeader taken_apart(const std::string& header) {
    const auto open = header.rfind(" (");
    if (open == header.npos || !header.ends_with(')')) return {header, ""};
    const std::string number =
        header.substr(open + 2, header.size() - open - 3);
    const bool is_number = !number.empty() && number.find_first_not_of(
                                                  "0123456789") == number.npos;
    return is_number ? AssignmentHeader{header.substr(0, open), number}
                     : AssignmentHeader{header, ""};
}

std::size_t assignment_column(const CsvTable& table, const std::string& asked) {
    std::vector<std::size_t> found;
    std::string all;
    for (std::size_t k = 0; k < table.columns(); ++k) {
        const std::string header = table.value(0, k);
        const AssignmentHeader parts = taken_apart(header);
        if (parts.number.empty()) continue;
        all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ",
                           course::escape_terminal(header));
        if (asked == parts.number || asked == header ||
            plain_name(asked) == plain_name(parts.name))
            found.push_back(k);
    }
    if (found.size() == 1) return found[0];
    throw CsvError(fmt::format(
        "{} for the assignment \"{}\": say it with --column; there are {}",
        found.empty() ? "no column" : "several columns", asked,
        all.empty() ? "none" : all));
}

/// "rossianna": Canvas's files are named after the sortable name so.
std::string file_form(const std::string& name) {
    std::string form = plain_name(name);
    std::erase_if(form, [](char c) {
        return static_cast<unsigned char>(c) < 0x80 && c != '_' &&
               !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9');
    });
    return form;
}

/// The forms in which others may write "Rossi, Anna".
std::vector<std::string> forms_of(const std::string& sortable) {
    const auto comma = sortable.find(", ");
    if (comma == sortable.npos) return {sortable, file_form(sortable)};
    const std::string last = sortable.substr(0, comma),
                      first = sortable.substr(comma + 2);
    return {sortable, first + " " + last, last + " " + first,
            file_form(sortable)};
}

class Filling {
public:
    Filling(const std::string& gradebook, const std::vector<Grade>& grades,
            const std::string& column)
        : table_(gradebook), grades_(grades) {
        for (const std::string_view header : id_headers)
            ids_.push_back(column_named(table_, header));
        if (!ids_[0])
            throw CsvError(
                "not a gradebook of Canvas: there is no column \"ID\"");
        column_ = assignment_column(table_, column);
        decimal_ = decimal_of(table_, {column_});
        for (std::size_t row = 1; row < table_.rows() && !is_person(row); ++row)
            if (const auto points = number_in(table_.value(row, column_)))
                max_ = points;
    }

    FilledTable filled() {
        result_.notes.push_back(
            fmt::format("grades go into \"{}\"",
                        course::escape_terminal(table_.value(0, column_))));
        if (max_)
            note_scale(result_, grades_, *max_);
        else
            result_.notes.push_back("no maximum found: points as they are");
        Matches matches = match(table_, grades_, rows());
        result_.left = std::move(matches.left);
        for (const auto [grade, row] : matches.pairs) fill(grades_[grade], row);
        result_.text = table_.text();
        return std::move(result_);
    }

private:
    bool is_person(std::size_t row) const {
        return !table_.value(row, *ids_[0]).empty();
    }

    std::vector<std::string> names(std::size_t row) const {
        const Column last = column_named(table_, "LastName"),
                     first = column_named(table_, "FirstName"),
                     whole = column_named(table_, "Student");
        if (whole) return forms_of(table_.value(row, *whole));
        if (!last || !first) return {};
        return forms_of(table_.value(row, *last) + ", " +
                        table_.value(row, *first));
    }

    std::vector<PersonRow> rows() const {
        std::vector<PersonRow> rows;
        for (std::size_t row = 1; row < table_.rows(); ++row) {
            if (!is_person(row)) continue;
            PersonRow one{row, {}, names(row), ""};
            for (const Column& id : ids_)
                one.keys.push_back(id ? table_.value(row, *id) : "");
            rows.push_back(std::move(one));
        }
        return rows;
    }

    void fill(const Grade& grade, std::size_t row) {
        const std::string name = course::escape_terminal(grade.student);
        const std::string before = table_.value(row, column_);
        if (!grade.total) {
            result_.left.push_back(without_grade(grade));
        } else if (plain_name(before) == "ex" || plain_name(before) == "n/a") {
            result_.left.push_back(
                fmt::format("{}: line {} has {}, which stays", name,
                            table_.line(row), course::escape_terminal(before)));
        } else {
            const std::string points = number_text(
                max_ ? scaled(grade, *max_) : *grade.total, decimal_);
            if (number_in(before) != number_in(points))
                table_.set(row, column_, points);
            ++result_.filled;
        }
    }

    CsvTable table_;
    const std::vector<Grade>& grades_;
    std::vector<Column> ids_;
    std::size_t column_ = 0;
    std::optional<double> max_;
    Decimal decimal_ = Decimal::point;
    FilledTable result_;
};

}  // namespace

FilledTable filled_gradebook(const std::string& gradebook,
                             const std::vector<Grade>& grades,
                             const std::string& column) {
    return Filling(gradebook, grades, column).filled();
}

}  // namespace grader
