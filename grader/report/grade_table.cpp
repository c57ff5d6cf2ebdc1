#include "grader/report/grade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "course/report/escape.h"
#include "course/report/text.h"

namespace grader {

using course::escape_terminal;
using course::points_text;

namespace {

using Rows = std::vector<const PersonRow*>;

/// "Anna Rossi_1234", as ingest shortens the names of exports.
std::optional<PlatformName> parse_short(const std::string& name) {
    const auto last = name.find_last_not_of("0123456789");
    if (last == name.npos || last == 0 || last + 1 == name.size() ||
        name[last] != '_')
        return std::nullopt;
    return PlatformName{name.substr(0, last), name.substr(last + 1)};
}

PlatformName name_of(const Student& student, const Member& member,
                     Platform from) {
    if (!member.number.empty() || !student.members.empty())
        return {member.name, member.number};
    const auto parse = from == Platform::canvas ? parse_canvas : parse_moodle;
    if (const auto name = parse(student.name)) return *name;
    return parse_short(student.name).value_or(PlatformName{student.name, ""});
}

std::string feedback(const ClassSummary& results, const Scores& scores,
                     const Total& sum) {
    std::string text =
        fmt::format("{} of {} points.", points_text(sum.total.value_or(0)),
                    points_text(sum.max));
    for (std::size_t k = 0; k < scores.size(); ++k) {
        const GradedExercise& one = results.exercises[k];
        if (!scores[k]) continue;
        text += fmt::format(
            "{} {}: {} of {}, {}", k == 0 ? "" : ";", short_name(one.exercise),
            points_text(scores[k]->points), points_text(one.suite.max),
            words(scores[k]->verdict));
        if (scores[k]->by_hand) text += ", set by hand";
        if (one.weight != 1 || one.is_bonus)
            text += ", weight " + weight_text(one);
    }
    text += ".";
    if (const std::string late = late_text(scores); !late.empty())
        text += fmt::format(" Handed in {}.", late);
    return text;
}

/// The rows that `fits` holds for.
template <class Fits>
Rows rows_where(const std::vector<PersonRow>& rows, const Fits& fits) {
    Rows found;
    for (const PersonRow& row : rows)
        if (fits(row)) found.push_back(&row);
    return found;
}

/// Of the keys, the surest that is anybody's decides.
Rows rows_by_key(const std::vector<PersonRow>& rows, const std::string& key) {
    for (std::size_t k = 0; k < rows[0].keys.size(); ++k)
        if (Rows found = rows_where(
                rows, [&](const PersonRow& row) { return row.keys[k] == key; });
            !found.empty())
            return found;
    return {};
}

Rows rows_by_name(const std::vector<PersonRow>& rows, const std::string& name) {
    return rows_where(rows, [&](const PersonRow& row) {
        return std::any_of(row.names.begin(), row.names.end(),
                           [&](const std::string& other) {
                               return plain_name(other) == plain_name(name);
                           });
    });
}

Rows rows_of_team(const std::vector<PersonRow>& rows, const std::string& team) {
    return rows_where(rows, [&](const PersonRow& row) {
        return !row.group.empty() && plain_name(row.group) == plain_name(team);
    });
}

std::string who(const Grade& grade) {
    return escape_terminal(grade.student);
}

/// The lines of the rows: "lines 3, 9".
std::string lines_of(const CsvTable& table, const Rows& rows) {
    std::string text = "lines";
    for (const PersonRow* row : rows)
        text += fmt::format("{} {}", row == rows[0] ? "" : ",",
                            table.line(row->row));
    return text;
}

/// Goes through the grades, then through the rows.
class Matcher {
public:
    Matcher(const CsvTable& table, const std::vector<Grade>& grades,
            const std::vector<PersonRow>& rows)
        : table_(table), grades_(grades), rows_(rows) {}

    Matches matches() {
        for (std::size_t g = 0; g < grades_.size(); ++g)
            for (const PersonRow* row : rows_of(grades_[g]))
                claims_[row].push_back(g);
        for (const PersonRow& row : rows_) look_at(row);
        return std::move(result_);
    }

private:
    Rows rows_of(const Grade& grade) {
        if (rows_.empty()) return {};
        Rows found;
        if (!grade.key.empty()) found = rows_by_key(rows_, grade.key);
        // A folder's whole name is nobody's where it is that of an export.
        if (found.empty()) found = rows_by_key(rows_, grade.student);
        if (found.empty()) found = rows_by_name(rows_, grade.student);
        if (found.size() > 1) {
            left("{}: {} all fit, none is taken", who(grade),
                 lines_of(table_, found));
            return {};
        }
        if (found.empty()) found = rows_of_team(rows_, grade.person);
        if (found.empty()) left("{}: has no row in the table", who(grade));
        return found;
    }

    void look_at(const PersonRow& row) {
        const auto& claims = claims_[&row];
        if (claims.size() == 1) {
            result_.pairs.push_back({claims[0], row.row});
            return;
        }
        const std::string name =
            row.names.empty() ? "" : escape_terminal(row.names[0]);
        if (claims.empty())
            left("line {}: {} handed in nothing", table_.line(row.row), name);
        else
            left("line {}: {} and {} both fit, none is taken",
                 table_.line(row.row), who(grades_[claims[0]]),
                 who(grades_[claims[1]]));
    }

    template <class... Parts>
    void left(fmt::format_string<Parts...> text, Parts&&... parts) {
        result_.left.push_back(
            fmt::format(text, std::forward<Parts>(parts)...));
    }

    const CsvTable& table_;
    const std::vector<Grade>& grades_;
    const std::vector<PersonRow>& rows_;
    std::map<const PersonRow*, std::vector<std::size_t>> claims_;
    Matches result_;
};

}  // namespace

std::vector<Grade> grades_for(const ClassSummary& results, Platform from) {
    std::vector<Grade> grades;
    for (std::size_t k = 0; k < results.students.size(); ++k) {
        const Student& student = results.run.students[k];
        const Scores& scores = results.students[k];
        const Total sum = total(results, scores);
        for (const Member& member : people_of(student)) {
            const PlatformName name = name_of(student, member, from);
            grades.push_back(
                {student.members.empty() ? student.name : member.name, name.key,
                 name.person, sum.total, sum.max, status(scores),
                 feedback(results, scores, sum)});
        }
    }
    return grades;
}

Matches match(const CsvTable& table, const std::vector<Grade>& grades,
              const std::vector<PersonRow>& rows) {
    return Matcher(table, grades, rows).matches();
}

double scaled(const Grade& grade, double max) {
    return grade.max > 0 ? *grade.total * max / grade.max : 0;
}

void note_scale(FilledTable& table, const std::vector<Grade>& grades,
                double max) {
    if (grades.empty() || grades[0].max == max) return;
    table.notes.push_back(fmt::format(
        "points are scaled: {} of the assignment are {} of the table",
        points_text(grades[0].max), points_text(max)));
}

std::string without_grade(const Grade& grade) {
    return fmt::format("{}: {}, which is no grade: the row stays as it is",
                       who(grade), words(grade.status));
}

}  // namespace grader
