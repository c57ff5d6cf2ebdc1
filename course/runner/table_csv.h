// Reads the half-edge table that students fill in as a CSV file. The text comes
// from them: any bytes may be in it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace course {

/// Thrown when a text is not a table. The message has a line for each defect:
/// where it is, what was found, what was expected. After the first twenty it
/// only says how many more there are.
struct CsvError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The rows of the table as they are written, five cells each: half_edge, vi,
/// fi, next, opp. A blank cell is std::nullopt, and `-` is -1, as on the
/// slides.
///
/// The text is at most 1 MiB. Lines end with LF or CRLF; blank lines and lines
/// that start with # are skipped; the first other line is the header
/// `half_edge,vi,fi,next,opp`. Blanks round a cell, and the mark that some
/// editors put before UTF-8, do not matter. What the numbers say is not
/// checked, nor how many rows there are.
///
/// Errors: CsvError with all defects. Cost: linear in the text.
std::vector<std::vector<std::optional<int>>> parse_table_csv(
    std::string_view text);

}  // namespace course
