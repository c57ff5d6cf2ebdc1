// Due dates, late days and rounding. All expected values were computed by hand.
#include "grader/pipeline/lateness.h"

#include <vector>

#include "course/runner/catch2.h"

using namespace grader;

namespace {

constexpr auto none = LatePolicy::Kind::none;
constexpr auto refuse = LatePolicy::Kind::refuse;
constexpr auto percent = LatePolicy::Kind::percent_per_day;

DueDate due(const std::string& local, const std::string& zone) {
    return {instant_of(local, zone), zone};
}

struct Row {
    std::string submitted;  ///< UTC
    LatePolicy policy;
    int days;
    double factor;
};

void check(const DueDate& at, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        CAPTURE(row.submitted);
        const Lateness late =
            lateness(at, row.policy, instant_of(row.submitted));
        CHECK(late.days == row.days);
        CHECK(late.factor == Approx(row.factor));
    }
}

}  // namespace

TEST_CASE("local times become moments by the zone's own rules") {
    // Winter: one hour before UTC. Summer: two.
    CHECK(text_of(instant_of("2026-12-11T23:59:00", "Europe/Rome")) ==
          "2026-12-11T22:59:00Z");
    CHECK(text_of(instant_of("2026-07-01T00:30:00", "Europe/Rome")) ==
          "2026-06-30T22:30:00Z");
    CHECK(text_of(instant_of("2026-07-01T00:30:00", "UTC")) ==
          "2026-07-01T00:30:00Z");
}

TEST_CASE("of an hour that comes twice the later one is meant") {
    // Clocks are put back on 25 October 2026 at 03:00 to 02:00.
    CHECK(text_of(instant_of("2026-10-25T02:30:00", "Europe/Rome")) ==
          "2026-10-25T01:30:00Z");
}

TEST_CASE("times and zones that do not exist are errors") {
    // Clocks are put forward on 29 March 2026 at 02:00 to 03:00.
    CHECK_THROWS_WITH(
        instant_of("2026-03-29T02:30:00", "Europe/Rome"),
        "2026-03-29T02:30:00 does not exist in Europe/Rome: the clocks are put "
        "forward");
    CHECK_THROWS_AS(instant_of("2026-03-29T12:00:00", "Europe/Rom"), TimeError);
    CHECK_THROWS_AS(instant_of("2026-13-29T12:00:00", "UTC"), TimeError);
    CHECK_THROWS_AS(instant_of("2026-03-29T12:00:00", std::string("Z")),
                    TimeError);
    CHECK_THROWS_AS(instant_of("2026-03-29T12:00:00"), TimeError);
    CHECK_THROWS_AS(instant_of("2026-03-29T12:00:00Z and more"), TimeError);
}

TEST_CASE("each day that has begun takes off a part") {
    const LatePolicy ten = {percent, 10, 0, 0, {}};
    check(due("2026-12-11T23:59:00", "Europe/Rome"),
          {{"2026-12-01T00:00:00Z", ten, 0, 1},
           {"2026-12-11T22:59:00Z", ten, 0, 1},
           {"2026-12-11T22:59:01Z", ten, 1, 0.9},
           {"2026-12-12T22:59:00Z", ten, 1, 0.9},
           {"2026-12-12T22:59:01Z", ten, 2, 0.8},
           {"2026-12-21T22:59:00Z", ten, 10, 0},
           {"2026-12-25T22:59:00Z", ten, 14, 0}});
}

TEST_CASE("grace moves the due date by minutes, for every day") {
    const LatePolicy grace = {percent, 10, 1, 0, {}};
    check(due("2026-12-11T23:59:00", "Europe/Rome"),
          {{"2026-12-11T22:59:59Z", grace, 0, 1},
           {"2026-12-11T23:00:00Z", grace, 0, 1},
           {"2026-12-11T23:00:01Z", grace, 1, 0.9},
           {"2026-12-12T23:00:00Z", grace, 1, 0.9},
           {"2026-12-12T23:00:01Z", grace, 2, 0.8}});
}

TEST_CASE(
    "free days cost nothing, and work after the last day counts nothing") {
    const LatePolicy policy = {percent, 25, 0, 2, 4};
    check(due("2026-12-11T12:00:00", "UTC"),
          {{"2026-12-12T12:00:00Z", policy, 1, 1},
           {"2026-12-13T12:00:00Z", policy, 2, 1},
           {"2026-12-13T12:00:01Z", policy, 3, 0.75},
           {"2026-12-15T12:00:00Z", policy, 4, 0.5},
           {"2026-12-15T12:00:01Z", policy, 5, 0}});
}

TEST_CASE("late work is only marked, or refused") {
    check(due("2026-12-11T12:00:00", "UTC"),
          {{"2026-12-12T11:00:00Z", {none, 0, 0, 0, {}}, 1, 1},
           {"2026-12-13T13:00:00Z", {none, 0, 0, 0, 2}, 3, 0},
           {"2026-12-11T12:00:00Z", {refuse, 0, 0, 0, {}}, 0, 1},
           {"2026-12-11T12:00:01Z", {refuse, 0, 0, 0, {}}, 1, 0}});
}

TEST_CASE("a day is one on the clock, also when the clocks are changed") {
    const LatePolicy ten = {percent, 10, 0, 0, {}};
    // Due Saturday 24 October 23:59 in summer time: 21:59 UTC. The day after
    // ends on Sunday at 23:59 in winter time: 22:59 UTC, 25 hours later.
    check(due("2026-10-24T23:59:00", "Europe/Rome"),
          {{"2026-10-24T21:59:00Z", ten, 0, 1},
           {"2026-10-25T21:59:30Z", ten, 1, 0.9},
           {"2026-10-25T22:59:00Z", ten, 1, 0.9},
           {"2026-10-25T22:59:01Z", ten, 2, 0.8}});
    // Due Saturday 28 March 23:59 in winter time: 22:59 UTC. The day after ends
    // at 21:59 UTC, 23 hours later.
    check(due("2026-03-28T23:59:00", "Europe/Rome"),
          {{"2026-03-29T21:59:00Z", ten, 1, 0.9},
           {"2026-03-29T21:59:01Z", ten, 2, 0.8}});
    // Due in the hour that comes twice, its second time: 01:30 UTC.
    check(due("2026-10-25T02:30:00", "Europe/Rome"),
          {{"2026-10-25T00:45:00Z", ten, 0, 1},
           {"2026-10-25T01:30:01Z", ten, 1, 0.9}});
}

TEST_CASE("halves are rounded up, as they are written") {
    CHECK(rounded(2.675, 0.01) == Approx(2.68));
    CHECK(rounded(2.674, 0.01) == Approx(2.67));
    CHECK(rounded(0.125, 0.01) == Approx(0.13));
    CHECK(rounded(7.25, 0.5) == Approx(7.5));
    CHECK(rounded(7.2, 0.5) == Approx(7));
    CHECK(rounded(17.5, 1) == Approx(18));
    CHECK(rounded(1.0 / 3, 0) == 1.0 / 3);
}

TEST_CASE("times are read in the forms that platforms write") {
    for (const char* text :
         {"2026-12-11T22:59:00Z", "2026-12-11 22:59:00.514871000 Z",
          "2026-12-11 22:59:00 UTC", "2026-12-11T23:59:00+01:00",
          "2026-12-11 17:59:00.5 -0500", "2026-12-11T23:59",
          "2026-12-11 23:59:00", "Friday, 11 December 2026, 11:59 PM"}) {
        CAPTURE(text);
        CHECK(text_of(instant_in(text, "Europe/Rome")) ==
              "2026-12-11T22:59:00Z");
    }
    for (const char* text :
         {"", "-", "tomorrow", "2026-12-11", "2026-13-11T22:59:00Z",
          "2026-12-11T25:59:00Z", "2026-12-11T22:59:00Zx",
          "2026-03-29T02:30:00", "1700000000"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(instant_in(text, "Europe/Rome"), TimeError);
    }
}

TEST_CASE("times are shown by the clocks of a zone") {
    const Instant summer = instant_of("2026-07-01T12:00:00Z");
    CHECK(text_in(summer, "Europe/Rome") == "2026-07-01 14:00 CEST");
    CHECK(text_in(summer, "UTC") == "2026-07-01 12:00 UTC");
}
