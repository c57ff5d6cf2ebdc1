// Whatever a student chose as a name or printed, it stays text in a report.
#include "course/report/escape.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "course/report/html.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace course;
using namespace grader;
using namespace grader::tests;

TEST_CASE("HTML: markup, quotes and ampersands become text") {
    CHECK(escape_html("<b a=\"x\" b='y'>&amp;</b>") ==
          "&lt;b a=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;&lt;/b&gt;");
    CHECK(escape_html("two\nlines\tand a tab") == "two\nlines\tand a tab");
}

TEST_CASE("HTML: what cannot be seen is spelled out") {
    CHECK(escape_html(std::string("\0\x1b\r\x7f", 4)) ==
          "\\x00\\x1B\\x0D\\x7F");
    CHECK(escape_html("a\u202Eb\u2066c\u200Fd\uFEFF") ==
          "a\\u202Eb\\u2066c\\u200Fd\\uFEFF");
    CHECK(escape_html("\u0085\u2028") == "\\x85\\u2028");
    CHECK(escape_html("\U000E0041") == "\\uE0041");
}

TEST_CASE("invalid UTF-8 is shown byte by byte, and the rest is kept") {
    CHECK(escape_html("a\xff\xc3(b") == "a\\xFF\\xC3(b");
    CHECK(escape_html("\xc0\xaf") == "\\xC0\\xAF");           // overlong '/'
    CHECK(escape_html("\xe0\x80\xaf") == "\\xE0\\x80\\xAF");  // overlong
    CHECK(escape_html("\xed\xa0\x80") == "\\xED\\xA0\\x80");  // surrogate
    CHECK(escape_html("\xf4\x90\x80\x80") == "\\xF4\\x90\\x80\\x80");
    CHECK(escape_html("\xf0\x9f\x98") == "\\xF0\\x9F\\x98");  // cut short
    CHECK(escape_html("\u00E8 \u4E2D \U0001F600") ==
          "\u00E8 \u4E2D \U0001F600");
}

TEST_CASE("a character is escaped alike alone and beside what is spelled out") {
    const std::string bad = "\xff";
    for (int code = 0; code < 128; ++code) {
        const std::string text(1, static_cast<char>(code));
        CAPTURE(code);
        CHECK(escape_html(bad + text) == "\\xFF" + escape_html(text));
        CHECK(escape_json(bad + text) == "\\xFF" + escape_json(text));
    }
}

TEST_CASE("XML: nothing that XML 1.0 forbids, and no end of a CDATA") {
    CHECK(escape_xml("]]>") == "]]&gt;");
    CHECK(escape_xml(std::string("\0\x0b\ufffe\uffff", 8)) ==
          "\\x00\\x0B\\uFFFE\\uFFFF");
    CHECK(escape_xml("<a b='c'>\"&") == "&lt;a b=&#39;c&#39;&gt;&quot;&amp;");
}

TEST_CASE("CSV: fields are quoted where they must be") {
    CHECK(escape_csv("anna") == "anna");
    CHECK(escape_csv("Rossi, Anna") == "\"Rossi, Anna\"");
    CHECK(escape_csv("a;b") == "\"a;b\"");
    CHECK(escape_csv("the \"best\"") == "\"the \"\"best\"\"\"");
    CHECK(escape_csv("two\nlines") == "two\\nlines");
    CHECK(escape_csv("two\r\nlines") == "two\\x0D\\nlines");
    CHECK(escape_csv(" a ") == "\" a \"");
    CHECK(escape_csv("") == "");
}

TEST_CASE("CSV: nothing is a formula") {
    for (const char* text :
         {"=1+1", "+1", "-1", "@SUM(A1)", "=cmd|' /C x'!A0", "  =1", "\uFF1D1",
          "\uFF0B1", "\uFF0D1", "\uFF201"}) {
        CAPTURE(text);
        CHECK(escape_csv(text).substr(0, 2) == "\"'");
    }
    // Tabs and carriage returns in front are spelled out and hide nothing.
    CHECK(escape_csv("\t=1") == "\\t=1");
    CHECK(escape_csv("\r=1") == "\\x0D=1");
    CHECK(escape_csv("a=1") == "a=1");
}

TEST_CASE("terminal: no escape sequence, no second line, no turned text") {
    CHECK(escape_terminal("\x1b]0;title\x07\x1b[2J") ==
          "\\x1B]0;title\\x07\\x1B[2J");
    CHECK(escape_terminal("\xc2\x9b"
                          "31m") == "\\x9B31m");  // CSI as one code
    CHECK(escape_terminal("a\nb\tc\rd\be") == "a\\nb\\tc\\x0Dd\\x08e");
    CHECK(escape_terminal("\u202Eabc") == "\\u202Eabc");
}

TEST_CASE("markup escapes every value that is not markup itself") {
    const std::string name = "<i>&";
    CHECK(markup("<p>{} {} {} {:.1f}</p>", name, "\"", 3, 0.25).text ==
          "<p>&lt;i&gt;&amp; &quot; 3 0.2</p>");
    CHECK(markup("<p>{}</p>", markup("<b>{}</b>", "<")).text ==
          "<p><b>&lt;</b></p>");
    CHECK(markup("{}", std::string("{} {{")).text == "{} {{");
}

TEST_CASE("markup writes numbers as fmt does") {
    std::vector<double> numbers = {0.0,  -0.0, -0.04, 0.95,   99.95,    1e9,
                                   1e15, 1e22, 1e300, 5e-324, INFINITY, NAN};
    for (int k = -4000; k < 4000; ++k) {
        const double tie = k / 40.0;
        numbers.insert(numbers.end(), {tie, std::nextafter(tie, 1e9),
                                       std::nextafter(tie, -1e9), k / 64.0});
    }
    for (const double number : numbers) {
        const std::string expected =
            fmt::format("{:.1f} {:.0f}", number, number);
        if (markup("{:.1f} {:.0f}", number, number).text != expected)
            FAIL_CHECK(expected);
    }
    CHECK(markup("{} {}", std::uint64_t{18446744073709551615u}, -7).text ==
          "18446744073709551615 -7");
}

TEST_CASE("markup with too many or too few values is a mistake") {
    CHECK_THROWS_AS(markup("<p>", "more"), std::logic_error);
    CHECK_THROWS_AS(markup("<p>{}"), std::logic_error);
    CHECK_THROWS_AS(markup("{:.1f}", "text"), std::logic_error);
    CHECK_THROWS_AS(markup("{}", 0.5), std::logic_error);
}
