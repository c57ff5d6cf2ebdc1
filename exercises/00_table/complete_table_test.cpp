// The rules of the table, asked of each half-edge: a table that keeps them all,
// and the cells that were given, is the right one.
#include "exercises/00_table/complete_table.h"

#include <string>

#include "course/runner/suite.h"

using namespace course;

namespace {

using Table = std::vector<std::vector<TableCell>>;

constexpr int half_edge_count = 16;

enum Column { half_edge, vi, fi, next, opp };

/// The cell of half-edge i; nothing when it is blank or has no row.
TableCell cell(const Table& table, TableCell i, Column column) {
    for (const std::vector<TableCell>& row : table)
        if (i && row.at(half_edge) == i) return row.at(column);
    return std::nullopt;
}

/// How many rows have the number `value` in a column.
int count(const Table& table, Column column, int value) {
    int found = 0;
    for (const std::vector<TableCell>& row : table)
        if (row.at(column) == value) ++found;
    return found;
}

std::string cell_name(int i, Column column) {
    const std::string names[] = {"half_edge", "vi", "fi", "next", "opp"};
    return "half-edge " + std::to_string(i) + ", " + names[column];
}

using Names = std::vector<std::string>;

Names blank_cells(const Table& table) {
    Names names;
    for (int i = 0; i < half_edge_count; ++i)
        for (const Column column : {vi, fi, next, opp})
            if (!cell(table, i, column)) names.push_back(cell_name(i, column));
    return names;
}

}  // namespace

TEST_CASE("each half-edge has a row, and no cell of it is blank",
          "[points:1]") {
    hint("Which cell is still blank, and which rule of the table is about it?");
    const Table table = complete_table();
    CHECK(blank_cells(table) == Names{});
    CHECK(table.size() == half_edge_count);
    for (int i = 0; i < half_edge_count; ++i) {
        INFO(cell_name(i, half_edge));
        CHECK(count(table, half_edge, i) == 1);
    }
}

TEST_CASE("opp leads to the other half-edge of the same edge, and back",
          "[points:1]") {
    hint("Where does the opposite leave, and where does its own opp lead?");
    const Table table = complete_table();
    for (int i = 0; i < half_edge_count; ++i) {
        INFO(cell_name(i, opp));
        const TableCell j = cell(table, i, opp);
        CHECK(j != i);
        CHECK(cell(table, j, opp) == i);
        CHECK(cell(table, j, vi) != cell(table, i, vi));
    }
}

TEST_CASE("next leaves where i arrives, on the same face or border",
          "[points:1]") {
    hint("At which vertex does i arrive, and which half-edges leave it?");
    const Table table = complete_table();
    for (int i = 0; i < half_edge_count; ++i) {
        INFO(cell_name(i, next));
        const TableCell j = cell(table, i, opp);
        const TableCell k = cell(table, i, next);
        CHECK(k.has_value());
        CHECK(cell(table, k, vi) == cell(table, j, vi));
        CHECK(cell(table, k, fi) == cell(table, i, fi));
        CHECK(count(table, next, i) == 1);
    }
}
