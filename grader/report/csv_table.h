// A CSV file whose cells can be replaced while every other byte stays as it is.
//
// The tables of course platforms go back to where they came from, and nothing
// but the grades may differ. Libraries for CSV (libcsv, rapidcsv) give the
// values of cells without their places in the file, and write a table anew by
// rules of their own: quotes, line ends, separator and byte order mark of the
// original are lost. So this remembers where each cell stands.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grader {

/// Not a table: a quote that is not closed, a row of another width, ...; the
/// message names the line.
struct CsvError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// RFC 4180, with what spreadsheets add: cells are separated by commas,
/// semicolons or tabs, whichever makes a table of it; rows end in LF, CRLF or,
/// where there is no LF, CR. A UTF-8 byte order mark is passed over. Rows and
/// columns count from 0, and row 0 is the header; blank lines are no rows.
class CsvTable {
public:
    /// Throws CsvError.
    explicit CsvTable(std::string text);

    std::size_t rows() const { return rows_.size(); }
    std::size_t columns() const { return rows_[0].cells.size(); }
    char separator() const { return separator_; }

    /// In the file, from 1: the one in which the row begins.
    int line(std::size_t row) const { return rows_[row].line; }

    /// What the cell says, without quotes. A cell that was set is as it was.
    std::string value(std::size_t row, std::size_t column) const;

    /// Replaces what the cell says. It is quoted where it was or has to be.
    void set(std::size_t row, std::size_t column, std::string_view value);

    /// The file, with the cells that were set.
    std::string text() const;

private:
    struct Cell {
        std::size_t begin, end;  ///< with its quotes
    };
    struct Row {
        int line;
        std::vector<Cell> cells;
    };
    class Reader;

    std::string text_;
    char separator_ = ',';
    std::vector<Row> rows_;
    /// By place in the file: end, and the bytes to stand there.
    std::map<std::size_t, std::pair<std::size_t, std::string>> replaced_;
};

/// The column of that header, letters of ASCII in any case; nothing where there
/// is none. Throws CsvError when there are several.
std::optional<std::size_t> column_named(const CsvTable& table,
                                        std::string_view name);

/// A number with a decimal point or, as in other countries, a comma; nothing
/// where the text is none.
std::optional<double> number_in(std::string_view text);

/// How a table writes decimals.
enum class Decimal { point, comma };

/// As the first number in these columns that has decimals; without one, a
/// comma where semicolons separate the cells.
Decimal decimal_of(const CsvTable& table,
                   const std::vector<std::size_t>& columns);

/// "7.5" or "7,5": two digits at most.
std::string number_text(double number, Decimal decimal);

/// A name as it is compared: letters of ASCII are small, underscores and runs
/// of blanks are one blank.
std::string plain_name(std::string_view name);

}  // namespace grader
