// Hidden suite of complete_table: cell by cell, a case for each column.
#include <string>

#include "course/runner/suite.h"
#include "exercises/00_table/complete_table.h"

using namespace course;

namespace {

enum Column { half_edge, vi, fi, next, opp };

int number(const HalfEdge& row, Column column) {
    switch (column) {
        case vi:
            return row.vi;
        case fi:
            return row.fi;
        case next:
            return row.next;
        default:
            return row.opp;
    }
}

/// Compares one column with the slide table; each failure names its cell. Not
/// OnMesh: a picture or a table of the mesh would be the answer.
void check_column(Column column, const std::string& name) {
    const Fixture slide = zoo::slide();
    const auto table = complete_table();
    for (int i = 0; i < slide.he.size(); ++i) {
        int rows = 0;
        for (const std::vector<TableCell>& row : table) {
            if (row.at(half_edge) != i) continue;
            ++rows;
            INFO("half-edge " << i << ", " << name);
            CHECK(row.at(column) ==
                  number(slide.he.rows()[static_cast<std::size_t>(i)], column));
        }
        INFO("half-edge " << i << " has one row");
        CHECK(rows == 1);
    }
    CHECK(static_cast<int>(table.size()) == slide.he.size());
}

}  // namespace

TEST_CASE("the column vi: where each half-edge leaves", "[points:2]") {
    hint("At which vertex does the half-edge before it arrive?");
    check_column(vi, "vi");
}

TEST_CASE("the column fi: along which face each half-edge runs", "[points:1]") {
    hint("Which face do the half-edges before and after it run along?");
    check_column(fi, "fi");
}

TEST_CASE("the column next: which half-edge follows", "[points:2]") {
    hint(
        "Which half-edges leave the vertex where it arrives? Which of them "
        "stays on the same face or border?");
    check_column(next, "next");
}

TEST_CASE("the column opp: the other half-edge of the edge", "[points:2]") {
    hint("Which half-edge runs between the same two vertices the other way?");
    check_column(opp, "opp");
}
