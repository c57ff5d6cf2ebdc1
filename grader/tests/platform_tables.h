// Tables as Moodle and Canvas export them, of a class of 40 made-up students
// whose names are of the kind that breaks tables: in several languages,
// separators, line ends and ways to quote. With the grades or without, so that
// what is filled in can be compared byte by byte.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

#include "grader/report/grade_table.h"

namespace grader::tests {

struct PlatformStudent {
    std::string first, last;
    std::string key;    ///< Moodle's number, Canvas's user id
    std::string login;  ///< also the address, and the other ids

    std::string full_name() const { return first + " " + last; }
};

inline std::vector<PlatformStudent> forty_students() {
    const std::vector<std::string> lasts = {
        "Rossi", "Núñez", "O'Neill \"Shi\"",    "Weber; Max", "da Silva, Jr",
        "<b>Bo", "李",    "=cmd|' /C calc'!A0", "Ünlü",       "@SUM(1)"};
    const std::vector<std::string> firsts = {"Anna", "Bruno", "José",
                                             "Zoë \xE2\x80\xAEx"};
    std::vector<PlatformStudent> all;
    for (std::size_t k = 0; k < 40; ++k)
        all.push_back({firsts[k / 10], lasts[k % 10],
                       std::to_string(482'900 + 7 * k),
                       fmt::format("user{:02}", k)});
    return all;
}

/// How a table is written.
struct Dialect {
    const char* name;
    char separator = ',';
    bool has_mark = false;  ///< a byte order mark
    const char* line_end = "\n";
    bool quotes_all = false;
    char decimal = '.';
    bool ends_with_line_end = true;
    /// Of Moodle's columns, in its order.
    std::vector<std::string> headers = {"Identifier",
                                        "Full name",
                                        "Email address",
                                        "Status",
                                        "Group",
                                        "Grade",
                                        "Maximum Grade",
                                        "Grade can be changed",
                                        "Online text",
                                        "Last modified (grade)",
                                        "Feedback comments"};
    const char* participant = "Participant ";
};

inline std::vector<Dialect> dialects() {
    std::vector<Dialect> all(4);
    all[0] = {"English"};
    all[1] = {"Italian", ';', true, "\r\n", false, ',', false};
    all[1].headers = {"Identificatore",
                      "Nome completo",
                      "Indirizzo email",
                      "Stato",
                      "Gruppo",
                      "Valutazione",
                      "Valutazione massima",
                      "La valutazione può cambiare",
                      "Testo online",
                      "Ultima modifica (valutazione)",
                      "Commenti di feedback"};
    all[1].participant = "Partecipante ";
    all[2] = {"Spanish", '\t', true, "\r\n", true, ','};
    all[2].headers[0] = "Identificador";
    all[2].headers[5] = "Calificación";
    all[2].headers[6] = "Calificación máxima";
    all[2].headers[10] = "Comentarios de retroalimentación";
    all[2].participant = "Participante ";
    all[3] = {"all quoted", ',', false, "\n", true, '.', false};
    return all;
}

inline std::string decimals(std::string number, const Dialect& dialect) {
    for (char& c : number)
        if (c == '.') c = dialect.decimal;
    return number;
}

inline std::string table_line(const std::vector<std::string>& cells,
                              const Dialect& dialect) {
    std::string line;
    for (const std::string& cell : cells) {
        const bool quotes = dialect.quotes_all ||
                            cell.find_first_of(std::string("\"\n") +
                                               dialect.separator) != cell.npos;
        std::string text = quotes ? "\"" : "";
        for (const char c : cell)
            text += quotes && c == '"' ? "\"\"" : std::string(1, c);
        line += (line.empty() && &cell == &cells[0]
                     ? ""
                     : std::string(1, dialect.separator)) +
                text + (quotes ? "\"" : "");
    }
    return line;
}

inline std::string table_text(const std::vector<std::vector<std::string>>& rows,
                              const Dialect& dialect) {
    std::string text = dialect.has_mark ? "\xEF\xBB\xBF" : "";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        text += table_line(rows[k], dialect);
        if (k + 1 < rows.size() || dialect.ends_with_line_end)
            text += dialect.line_end;
    }
    return text;
}

/// Grade and feedback of a student as they stand in a table.
struct Cells {
    std::string grade, feedback;
};
using CellsOf = std::function<Cells(std::size_t student)>;

/// Moodle's grading worksheet; five to a group.
inline std::string moodle_worksheet(const Dialect& dialect,
                                    const CellsOf& cells_of) {
    std::vector<std::vector<std::string>> rows = {dialect.headers};
    const auto students = forty_students();
    for (std::size_t k = 0; k < students.size(); ++k) {
        const Cells cells = cells_of(k);
        rows.push_back({dialect.participant + students[k].key,
                        students[k].full_name(),
                        students[k].login + "@example.org",
                        "Submitted for grading - Not marked",
                        fmt::format("Team {}", k / 5), cells.grade,
                        decimals("100.00", dialect), "Yes",
                        k % 7 == 0 ? "two\nlines, and \"quotes\"; so" : "", "-",
                        cells.feedback});
    }
    return table_text(rows, dialect);
}

/// Canvas's gradebook with three assignments, one of which is ours.
inline std::string canvas_gradebook(const Dialect& dialect,
                                    const CellsOf& cells_of) {
    const auto number = [&](const char* text) {
        return decimals(text, dialect);
    };
    std::vector<std::vector<std::string>> rows = {
        {"Student", "ID", "SIS User ID", "SIS Login ID", "Section",
         "First light (4711)", "First light, again (4712)", "Quiz (9)",
         "Assignments Current Score", "Final Grade"},
        {"", "", "", "", "", "Manual Posting", "", "", "(read only)",
         "(read only)"},
        {"    Points Possible", "", "", "", "", number("20.0"), number("5.0"),
         "3", "(read only)", "(read only)"}};
    const auto students = forty_students();
    for (std::size_t k = 0; k < students.size(); ++k)
        rows.push_back({students[k].last + ", " + students[k].first,
                        students[k].key, "S" + students[k].login,
                        students[k].login, "A; B", cells_of(k).grade,
                        number("2.50"), k % 3 == 0 ? "EX" : "", number("91.5"),
                        "B+"});
    return table_text(rows, dialect);
}

/// Points of the 40: halves up to 10, of 10.
inline double points_of_student(std::size_t k) {
    return static_cast<double>(k % 21) / 2;
}

/// Their grades, each with the folder's name that `folder` makes of a student.
inline std::vector<Grade> forty_grades(
    const std::function<Grade(const PlatformStudent&)>& named) {
    std::vector<Grade> grades;
    const auto students = forty_students();
    for (std::size_t k = 0; k < students.size(); ++k) {
        Grade one = named(students[k]);
        one.total = points_of_student(k);
        one.max = 10;
        one.status = Status::complete;
        one.feedback = fmt::format("{}; \"good\", so far", k);
        grades.push_back(std::move(one));
    }
    return grades;
}

}  // namespace grader::tests
