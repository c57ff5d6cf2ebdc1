#pragma once

#include <optional>
#include <vector>

/// A cell of the table: its number, or nothing where it was left blank.
using TableCell = std::optional<int>;

/// The table in complete_table.csv, which is the file to work on: there is no
/// C++ to write. Returns its rows as they are written, each with five cells:
/// half_edge, vi, fi, next, opp.
///
/// What to hand in: a row for each half-edge, 0 to 15, in any order and each
/// once, without a blank cell. The cells that are given keep their numbers; for
/// the others there is one right number each.
/// File: plain text, at most 1 MiB. The header `half_edge,vi,fi,next,opp`, then
/// a line for each row, with a comma between two cells. A cell is a whole
/// number, or `-` for -1 as on the slides, or blank. Blanks round a cell do not
/// matter; blank lines and lines that start with `#` are skipped.
/// Errors: a file that is written in another way is refused, with the line,
/// what was found, and what was expected. Slide mesh: it is the table of that
/// mesh. (Lecture "half-edge", slides 159-164 and 166)
std::vector<std::vector<TableCell>> complete_table();
