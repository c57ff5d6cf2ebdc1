// Widths, cuts, numbers and walks: the small parts of the reports' texts.
#include "course/report/text.h"

#include "course/report/explain.h"
#include "course/report/walk.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

std::vector<Visit> visits(const std::vector<int>& steps) {
    std::vector<Visit> all;
    for (const int step : steps) all.push_back({step, 1});
    return all;
}

}  // namespace

TEST_CASE("width counts columns, not bytes") {
    CHECK(course::width("anna") == 4);
    CHECK(course::width("\u00E8") == 1);
    CHECK(course::width("e\u0300") == 1);
    CHECK(course::width("\u4E2D\u6587") == 4);
    CHECK(course::width("\U0001F600") == 2);
}

TEST_CASE("a text that is too wide is cut and says so") {
    CHECK(course::fitted("anna", 4) == "anna");
    CHECK(course::fitted("annab", 4) == "ann…");
    CHECK(course::fitted("\u4E2D\u6587\u4E2D", 4) == "\u4E2D…");
    CHECK(course::width(course::fitted(std::string(1000, 'x'), 24)) == 24);
}

TEST_CASE("a long text keeps its head and its tail") {
    CHECK(course::shortened("short", 100, 10) == "short");
    const std::string line(1'000'000, 'x');
    const std::string cut =
        course::shortened("begin " + line + " end", 300, 10);
    CHECK(cut.size() < 400);
    CHECK(cut.substr(0, 6) == "begin ");
    CHECK(cut.substr(cut.size() - 4) == " end");
    CHECK_THAT(cut, Containing("[... 999710 bytes left out ...]"));
}

TEST_CASE("a text of many lines keeps whole lines") {
    std::string lines;
    for (int k = 0; k < 100; ++k) lines += std::to_string(k) + "\n";
    CHECK(course::shortened(lines, 10000, 6) ==
          "0\n1\n2\n3\n[... 276 bytes left out ...]\n98\n99\n");
}

TEST_CASE("no cut goes through a character") {
    std::string text;
    for (int k = 0; k < 500; ++k) text += "\u4E2D\U0001F600";
    for (std::size_t bytes = 30; bytes < 60; ++bytes)
        CHECK(course::visible(course::shortened(text, bytes, 10)).find("\\x") ==
              std::string::npos);
}

TEST_CASE("bytes that are no text do not disturb a cut") {
    const std::string junk(100'000, '\x80');
    CHECK(course::shortened(junk, 300, 10).size() < 400);
}

TEST_CASE("points have as many digits as they need, percents one") {
    CHECK(course::points_text(10) == "10");
    CHECK(course::points_text(7.5) == "7.5");
    CHECK(course::points_text(1.0 / 3) == "0.33");
    CHECK(course::points_text(100) == "100");
    CHECK(course::points_text(0) == "0");
    CHECK(course::points_text(-0.001) == "0");
    CHECK(course::percent_text(1, 3) == "33.3");
    CHECK(course::percent_text(3, 3) == "100.0");
    CHECK(course::percent_text(0, 0) == "0.0");
}

TEST_CASE("times are written for people where they can be read") {
    CHECK(course::time_text("2024-03-01T09:30:00Z") == "2024-03-01 09:30 UTC");
    CHECK(course::time_text("yesterday") == "yesterday");
}

TEST_CASE("a walk names the half-edges in order, each stay once") {
    const course::Walk walk = course::walk_of(visits({1, 1, 0, 0, 2}), 5);
    CHECK(course::walk_text(walk) == "he[1] he[0] he[2] and stopped");
    const auto order = course::walk_order(walk);
    CHECK(order.at(1) == "1");
    CHECK(order.at(2) == "3");
    CHECK(order.count(3) == 0);
}

TEST_CASE("a walk without end says which half-edges it goes round") {
    const course::Walk walk = course::walk_of(endless_walk(), 101024);
    CHECK(course::walk_text(walk) ==
          "he[4] he[3], again and again (101024 reads)");
    CHECK(course::walk_order(walk).at(3) == "2");
    const course::Walk still =
        course::walk_of(visits(std::vector<int>(64, 5)), 1000);
    CHECK(course::walk_text(still) == "he[5], again and again (1000 reads)");
}

TEST_CASE("a round of a walk is seen when it was walked three times") {
    std::vector<int> steps;
    for (int k = 0; k < 64; ++k) steps.push_back(k % 21);
    CHECK(course::walk_of(visits(steps), 1000).steps.size() == 21);
    for (int k = 0; k < 64; ++k) steps[static_cast<std::size_t>(k)] = k % 22;
    CHECK_FALSE(course::walk_of(visits(steps), 1000).repeats);
}

TEST_CASE("a walk that passes a half-edge often gets a short list") {
    const course::Walk walk =
        course::walk_of(visits({7, 1, 7, 2, 7, 3, 7, 4, 7, 5}), 10);
    CHECK(course::walk_order(walk).at(7) == "1, 3, 5, ...");
}

TEST_CASE("of a long walk only the end is known, so no step has a number") {
    std::vector<int> steps;
    for (int k = 0; k < 64; ++k) steps.push_back(k);
    const course::Walk walk = course::walk_of(visits(steps), 500);
    CHECK_THAT(course::walk_text(walk), Containing("... he[0] he[1] "));
    CHECK_THAT(course::walk_text(walk),
               Containing("and stopped (the end of 500 reads)"));
    CHECK(course::walk_order(walk).at(0).empty());
}

TEST_CASE("no walk has no text") {
    CHECK(course::walk_text(course::walk_of({}, 0)).empty());
}

TEST_CASE("the lines of a walk come in the order of the walk") {
    CHECK(lines_of(wrong_count()) == "8, 9");
    CHECK(lines_of(Failure()).empty());
}
