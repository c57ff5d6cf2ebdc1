#include "grader/report/moodle_worksheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "course/report/escape.h"
#include "course/report/text.h"

namespace grader {

namespace {

using Column = std::optional<std::size_t>;
using Headers = std::span<const std::string_view>;

// English, Italian, Spanish, Catalan, French, Portuguese, German, Dutch,
// Polish.
constexpr std::array<std::string_view, 14> grade_headers = {
    "Grade",  "Valutazione", "Voto",         "Calificación", "Qualificació",
    "Note",   "Nota",        "Avaliação",    "Bewertung",    "Beoordeling",
    "Cijfer", "Ocena",       "Calificacion", "Punteggio"};
constexpr std::array<std::string_view, 16> max_headers = {
    "Maximum Grade",       "Valutazione massima", "Voto massimo",
    "Punteggio massimo",   "Calificación máxima", "Calificacion maxima",
    "Qualificació màxima", "Note maximale",       "Nota máxima",
    "Avaliação máxima",    "Bestwertung",         "Beste Bewertung",
    "Maximale Bewertung",  "Maximumcijfer",       "Maximale beoordeling",
    "Ocena maksymalna"};
constexpr std::array<std::string_view, 17> feedback_headers = {
    "Feedback comments",
    "Commenti di feedback",
    "Commenti",
    "Feedback",
    "Comentarios de retroalimentación",
    "Comentarios de retroalimentacion",
    "Retroalimentación",
    "Comentaris de retroacció",
    "Feedback par commentaires",
    "Commentaires de feedback",
    "Commentaires",
    "Comentários de feedback",
    "Comentários",
    "Feedback als Kommentar",
    "Feedback-Kommentare",
    "Feedback als opmerking",
    "Komentarz zwrotny"};
constexpr std::array<std::string_view, 8> group_headers = {
    "Group", "Gruppo", "Grupo", "Grup", "Groupe", "Gruppe", "Groep", "Grupa"};
constexpr std::array<std::string_view, 1> changeable_headers = {
    "Grade can be changed"};

Column column_of(const CsvTable& table, Headers headers) {
    for (const std::string_view header : headers)
        if (const Column found = column_named(table, header)) return found;
    return std::nullopt;
}

/// The number of "Participant 1234", and what stands before it.
struct Numbered {
    std::string word, number;
};

Numbered numbered(const std::string& cell) {
    const auto last = cell.find_last_not_of("0123456789");
    if (last == cell.npos || last + 1 == cell.size()) return {};
    return {cell.substr(0, last + 1), cell.substr(last + 1)};
}

/// Whether every cell has the same word, and a number of its own.
bool has_keys(const CsvTable& table, std::size_t column) {
    std::set<std::string> words, numbers;
    for (std::size_t row = 1; row < table.rows(); ++row) {
        const Numbered one = numbered(table.value(row, column));
        words.insert(one.word);
        if (one.number.empty() || !one.word.ends_with(' ') ||
            !numbers.insert(one.number).second)
            return false;
    }
    return words.size() == 1;
}

/// Where what stands in a worksheet.
struct Layout {
    std::size_t key = 0, grade = 0;
    Column max, feedback, group, changeable;
};

std::string headers_of(const CsvTable& table) {
    std::string text;
    for (std::size_t k = 0; k < table.columns(); ++k)
        text += fmt::format("{}\"{}\"", k == 0 ? "" : ", ",
                            course::escape_terminal(table.value(0, k)));
    return text;
}

Column named_or(const CsvTable& table, const std::string& name,
                Headers headers) {
    if (name.empty()) return column_of(table, headers);
    if (const Column found = column_named(table, name)) return found;
    throw CsvError(fmt::format("there is no column \"{}\"; there are {}", name,
                               headers_of(table)));
}

Layout layout_of(const CsvTable& table, const MoodleOptions& options) {
    Layout layout;
    while (layout.key < table.columns() && !has_keys(table, layout.key))
        ++layout.key;
    if (layout.key == table.columns())
        throw CsvError(
            "not a grading worksheet of Moodle: no column has a \"Participant "
            "1234\" in each row");
    const Column grade = named_or(table, options.grade_column, grade_headers);
    if (!grade)
        throw CsvError(fmt::format(
            "which column has the grades? Say it with --grade-column; there "
            "are {}",
            headers_of(table)));
    layout.grade = *grade;
    layout.max = column_of(table, max_headers);
    layout.group = column_of(table, group_headers);
    layout.changeable = column_of(table, changeable_headers);
    if (options.with_feedback)
        layout.feedback =
            named_or(table, options.feedback_column, feedback_headers);
    return layout;
}

/// Fills one worksheet.
class Filling {
public:
    Filling(const std::string& worksheet, const std::vector<Grade>& grades,
            const MoodleOptions& options)
        : table_(worksheet),
          grades_(grades),
          layout_(layout_of(table_, options)),
          decimal_(decimal_of(table_, numbers())) {}

    FilledTable filled() {
        note_layout();
        Matches matches = match(table_, grades_, rows());
        result_.left = std::move(matches.left);
        for (const auto [grade, row] : matches.pairs) fill(grades_[grade], row);
        result_.text = table_.text();
        return std::move(result_);
    }

private:
    std::vector<std::size_t> numbers() const {
        if (layout_.max) return {*layout_.max, layout_.grade};
        return {layout_.grade};
    }

    std::string value(std::size_t row, const Column& column) const {
        return column ? table_.value(row, *column) : "";
    }

    /// What stands before the grade says who it is: name, login, address, in
    /// any language.
    std::vector<PersonRow> rows() const {
        std::vector<PersonRow> rows;
        for (std::size_t row = 1; row < table_.rows(); ++row) {
            PersonRow one{row, {}, {}, value(row, layout_.group)};
            one.keys = {numbered(table_.value(row, layout_.key)).number};
            for (std::size_t k = 0; k < layout_.grade; ++k)
                if (k != layout_.key && k != layout_.group &&
                    !table_.value(row, k).empty())
                    one.names.push_back(table_.value(row, k));
            rows.push_back(std::move(one));
        }
        return rows;
    }

    void note_layout() {
        result_.notes.push_back(fmt::format(
            "grades go into \"{}\"",
            course::escape_terminal(table_.value(0, layout_.grade))));
        if (layout_.feedback)
            result_.notes.push_back(fmt::format(
                "feedback goes into \"{}\"",
                course::escape_terminal(table_.value(0, *layout_.feedback))));
        else
            result_.notes.push_back("no feedback goes in");
        const auto most = number_in(value(1, layout_.max));
        if (most)
            note_scale(result_, grades_, *most);
        else
            result_.notes.push_back("no maximum found: points as they are");
    }

    void fill(const Grade& grade, std::size_t row) {
        const std::string name = course::escape_terminal(grade.student);
        if (!grade.total) {
            result_.left.push_back(without_grade(grade));
            return;
        }
        if (plain_name(value(row, layout_.changeable)) == "no") {
            result_.left.push_back(
                fmt::format("{}: line {} says that the grade cannot be changed",
                            name, table_.line(row)));
            return;
        }
        const auto most = number_in(value(row, layout_.max));
        double points = most ? scaled(grade, *most) : *grade.total;
        if (most && points > *most) {
            result_.left.push_back(fmt::format(
                "{}: {} points are above Moodle's maximum and count as {}",
                name, course::points_text(points), course::points_text(*most)));
            points = *most;
        }
        write(grade, row, number_text(points, decimal_));
    }

    void write(const Grade& grade, std::size_t row, const std::string& points) {
        const auto before = number_in(table_.value(row, layout_.grade));
        if (before != number_in(points)) table_.set(row, layout_.grade, points);
        if (layout_.feedback)
            table_.set(row, *layout_.feedback, grade.feedback);
        ++result_.filled;
    }

    CsvTable table_;
    const std::vector<Grade>& grades_;
    Layout layout_;
    Decimal decimal_;
    FilledTable result_;
};

}  // namespace

FilledTable filled_worksheet(const std::string& worksheet,
                             const std::vector<Grade>& grades,
                             const MoodleOptions& options) {
    return Filling(worksheet, grades, options).filled();
}

}  // namespace grader
