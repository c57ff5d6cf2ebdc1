// Tables whose cells are replaced: every other byte stays.
#include "grader/report/csv_table.h"

#include "course/runner/catch2.h"
#include "grader/tests/golden.h"

using namespace grader;
using grader::tests::Containing;

namespace {

std::string error_of(const std::string& text) {
    try {
        const CsvTable table(text);
    } catch (const CsvError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a table that nothing is set in is the same text") {
    for (const std::string text :
         {"a,b\n1,2\n", "a,b\r\n1,2", "a;b\r\r\n", "\xEF\xBB\xBF\"a\"\t\"b\"\n",
          "a,b\n\n1,2\n\n", "a,\"b\"\"\n,c\"\n,\n", "a,b\r1,2\r", "a\n1\n"}) {
        INFO(text);
        CHECK(CsvTable(text).text() == text);
    }
}

TEST_CASE("cells say what stands in them, quoted or not") {
    const CsvTable table(
        "\xEF\xBB\xBFname,\"of \"\"it\"\"\"\r\n\"a,b\r\nc\", x\"y "
        "\r\n,\"\"\r\n");
    REQUIRE(table.rows() == 3);
    REQUIRE(table.columns() == 2);
    CHECK(table.value(0, 0) == "name");
    CHECK(table.value(0, 1) == "of \"it\"");
    CHECK(table.value(1, 0) == "a,b\r\nc");
    CHECK(table.value(1, 1) == " x\"y ");
    CHECK(table.value(2, 0).empty());
    CHECK(table.value(2, 1).empty());
    CHECK(table.line(1) == 2);
    CHECK(table.line(2) == 4);
}

TEST_CASE("the separator is the one that makes a table of it") {
    CHECK(CsvTable("a,b;c,d\n1,2;3,4\n").separator() == ',');
    CHECK(CsvTable("a;b;c\n1,5;2,5;3\n").separator() == ';');
    CHECK(CsvTable("a\tb\n1,5\t2;5\n").separator() == '\t');
    CHECK(CsvTable("\"a,b\";\"c\"\n1;2\n").separator() == ';');
}

TEST_CASE("a cell that is set is quoted where it was or has to be") {
    CsvTable table("a,b,c\r\n1,\"2\",\r\n");
    table.set(1, 0, "7.5");
    table.set(1, 1, "say \"x\"");
    table.set(1, 2, "one, two");
    CHECK(table.text() == "a,b,c\r\n7.5,\"say \"\"x\"\"\",\"one, two\"\r\n");
    table.set(1, 0, "");
    table.set(1, 2, "three");
    CHECK(table.text() == "a,b,c\r\n,\"say \"\"x\"\"\",three\r\n");
}

TEST_CASE("what is no table is refused with the line") {
    CHECK_THAT(error_of("a,b\n1,2\n1,2,3\n"), Containing("line 3: 3 cells"));
    CHECK_THAT(error_of("a,b\n1,\"2\n3,4\n"), Containing("line 2: a quote"));
    CHECK_THAT(error_of("a,b\n1,\"2\" x\n"), Containing("line 2: something"));
    CHECK_THAT(error_of(""), Containing("empty"));
    CHECK_THAT(error_of(std::string("a\0,\0b\0", 6)), Containing("UTF-8"));
}

TEST_CASE("columns are found by their header, if it is the only one") {
    const CsvTable table("Full name,GRADE,x,X\n,,,\n");
    CHECK(column_named(table, "full  Name") == 0);
    CHECK(column_named(table, "Grade") == 1);
    CHECK_FALSE(column_named(table, "Grades"));
    CHECK_THROWS_AS(column_named(table, "x"), CsvError);
}

TEST_CASE("numbers are read and written with point and comma") {
    CHECK(number_in("7.50") == 7.5);
    CHECK(number_in(" 7,5 ") == 7.5);
    for (const char* text : {"", "-", "EX", "1.000,5", "7,5 %", "nan", "inf"}) {
        INFO(text);
        CHECK_FALSE(number_in(text));
    }
    CHECK(number_text(7.5, Decimal::comma) == "7,5");
    CHECK(number_text(10, Decimal::comma) == "10");
    CHECK(number_text(1.0 / 3, Decimal::point) == "0.33");
    CHECK(decimal_of(CsvTable("a;b\n1;2\n"), {1}) == Decimal::comma);
    CHECK(decimal_of(CsvTable("a;b\n1;2.5\n"), {1}) == Decimal::point);
    CHECK(decimal_of(CsvTable("a,b\n1,\"2,5\"\n"), {1}) == Decimal::comma);
    CHECK(decimal_of(CsvTable("a,b\n\"1,5\",2\n"), {1}) == Decimal::point);
}
