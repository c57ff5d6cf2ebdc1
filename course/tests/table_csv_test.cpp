// The table that students fill in, as a file: what is read, and what is said of
// a file that cannot be.
#include "course/runner/table_csv.h"

#include <algorithm>
#include <random>
#include <string>

#include "course/runner/catch2.h"

using course::CsvError;
using course::parse_table_csv;

namespace {

using Rows = std::vector<std::vector<std::optional<int>>>;

constexpr auto blank = std::nullopt;
const std::string header = "half_edge,vi,fi,next,opp\n";

/// The message of the error that the text gives; empty when it gives none.
std::string error_of(const std::string& text) {
    try {
        parse_table_csv(text);
    } catch (const CsvError& error) {
        return error.what();
    }
    return "";
}

std::string error_of_row(const std::string& row) {
    return error_of(header + row + "\n");
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a row is five cells, and a dash is -1") {
    CHECK(parse_table_csv(header + "0,2,-,2,1\n7,4,-1,10,15\n") ==
          Rows{{0, 2, -1, 2, 1}, {7, 4, -1, 10, 15}});
}

TEST_CASE("a blank cell is no number") {
    CHECK(parse_table_csv(header + "0,,-,2,\n,,,,\n") ==
          Rows{{0, blank, -1, 2, blank}, {blank, blank, blank, blank, blank}});
}

TEST_CASE("rows come in the order in which they are written") {
    CHECK(parse_table_csv(header + "5,0,0,0,0\n3,0,0,0,0\n") ==
          Rows{{5, 0, 0, 0, 0}, {3, 0, 0, 0, 0}});
}

TEST_CASE("comments, blank lines and blanks round a cell do not matter") {
    CHECK(parse_table_csv("# note, with commas\n\n \t \n  # another\n"
                          " half_edge , vi,fi,next,opp \n"
                          "# between\n 0 ,\t2 , - ,2,1\n\n") ==
          Rows{{0, 2, -1, 2, 1}});
}

TEST_CASE("files of other systems and editors are read as well") {
    const Rows expected = {{0, 2, -1, 2, 1}};
    SECTION("lines that end with CRLF") {
        CHECK(parse_table_csv(
                  "# c\r\nhalf_edge,vi,fi,next,opp\r\n0,2,-,2,1\r\n") ==
              expected);
    }
    SECTION("no end of line after the last row") {
        CHECK(parse_table_csv(header + "0,2,-,2,1") == expected);
    }
    SECTION("the mark before UTF-8") {
        CHECK(parse_table_csv("\xEF\xBB\xBF" + header + "0,2,-,2,1") ==
              expected);
    }
}

TEST_CASE("a header without rows is an empty table") {
    CHECK(parse_table_csv(header).empty());
}

TEST_CASE("what a cell may not hold is named with line and column") {
    const std::string expected =
        ", expected a whole number, the plain sign - for none, or nothing";
    const auto message = [&](const std::string& where) {
        return "the file is not a half-edge table:\n" + where + expected;
    };
    CHECK(error_of_row("0,x,-,2,1") == message("line 2, vi: found \"x\""));
    CHECK(error_of_row("0,2,-,2.0,1") ==
          message("line 2, next: found \"2.0\""));
    CHECK(error_of_row("0,2,-,2,+1") == message("line 2, opp: found \"+1\""));
    CHECK(error_of_row("0,2,--1,2,1") == message("line 2, fi: found \"--1\""));
    CHECK(error_of_row("H0,2,-,2,1") ==
          message("line 2, half_edge: found \"H0\""));
    CHECK(error_of_row("0,1 2,-,2,1") == message("line 2, vi: found \"1 2\""));
    CHECK(error_of_row("0,2,-,0x2,1") ==
          message("line 2, next: found \"0x2\""));
    CHECK(error_of_row("0,2147483648,-,2,1") ==
          message("line 2, vi: found \"2147483648\""));
}

TEST_CASE("the largest and the smallest number are numbers") {
    CHECK(parse_table_csv(header + "0,2147483647,-2147483648,00,-0") ==
          Rows{{0, 2147483647, -2147483647 - 1, 0, 0}});
}

TEST_CASE("a long dash, as it stands on slides, is shown byte by byte") {
    CHECK(contains(error_of_row("0,2,\xE2\x80\x93,2,1"),
                   "line 2, fi: found \"\\xE2\\x80\\x93\""));
}

TEST_CASE("a row with another number of cells is quoted") {
    CHECK(error_of_row("0,2,-,2") ==
          "the file is not a half-edge table:\n"
          "line 2: found 4 cells in \"0,2,-,2\", expected 5 with commas "
          "between them");
    CHECK(error_of_row("0;2;-;2;1") ==
          "the file is not a half-edge table:\n"
          "line 2: found 1 cell in \"0;2;-;2;1\", expected 5 with commas "
          "between them");
}

TEST_CASE("a missing header is named, and the rows are checked all the same") {
    CHECK(error_of("# note\n0,2,-,2,1\n1,y,0,3,0\n") ==
          "the file is not a half-edge table:\n"
          "line 2: found \"0,2,-,2,1\", expected half_edge,vi,fi,next,opp\n"
          "line 3, vi: found \"y\", expected a whole number, the plain sign - "
          "for none, or nothing");
    CHECK(error_of("") ==
          "the file is not a half-edge table:\n"
          "line 1: found the end of the file, expected "
          "half_edge,vi,fi,next,opp");
}

TEST_CASE("one message holds all defects, and counts what would be too many") {
    std::string text = header;
    for (int i = 0; i < 1000; ++i) text += "a,b\n";
    const std::string message = error_of(text);
    CHECK(contains(message, "\nline 21: "));
    CHECK(contains(message, "\nand 980 more"));
    CHECK(std::count(message.begin(), message.end(), '\n') == 21);
}

TEST_CASE("whatever the bytes are, the message is short and printable") {
    std::mt19937 random(1);
    const std::string likely =
        "0123456789,-\n\r\n#, \t\x80\xFF" + std::string(1, '\0') + "\"'<;";
    for (int trial = 0; trial < 2000; ++trial) {
        std::string text = trial % 2 == 0 ? header : "";
        const auto size = random() % 400;
        while (text.size() < size) text += likely[random() % likely.size()];
        const std::string message = error_of(text);
        CHECK(message.size() < 10000);
        CHECK(std::all_of(message.begin(), message.end(), [](char c) {
            return c == '\n' || (c >= ' ' && c <= '~');
        }));
    }
}

TEST_CASE("a large text ends soon, a larger one is refused") {
    constexpr std::size_t largest = std::size_t{1} << 20;
    for (const char byte : {'\0', ',', '\n', '1', ' ', '#', '\xFF'}) {
        CAPTURE(static_cast<int>(byte));
        CHECK(error_of(header + std::string(largest - header.size(), byte))
                  .size() < 10000);
    }
    CHECK(error_of(std::string(largest + 1, '#')) ==
          "the file is not a half-edge table:\nline 1: found 1048577 bytes in "
          "the file, expected at most 1048576");
}
