// `grader assignment check`: what an instructor reads of an assignment file.
#include <fstream>

#include "course/runner/temporary_folder.h"
#include "grader/tests/grader_program.h"

using namespace grader::tests;

namespace {

/// What the command says of a file with that text.
Said checked(const std::string& text) {
    const course::TemporaryFolder folder;
    const auto file = folder / "week1.toml";
    std::ofstream(file) << text;
    return grader_says({"assignment", "check", file.string()});
}

}  // namespace

TEST_CASE("a good assignment is summed up, with its due date in both clocks") {
    const Said said = checked(
        "name = 'Week 1'\ndue = 2026-12-11T23:59:00\n"
        "time_zone = 'Europe/Rome'\nrounding = 0.5\nteams = true\n"
        "[late]\npolicy = 'percent_per_day'\npercent_per_day = 12.5\n"
        "grace_minutes = 10\nfree_days = 2\nlast_day = 7\n"
        "[exercises]\nprev = 1.5\n[bonus]\nface_sides = 1\n");
    INFO(said.text);
    CHECK(said.code == 0);
    for (const char* part :
         {"Week 1, exercises: 2", "prev                     x 1.5",
          "face_sides               x 1 (bonus)",
          "due: 2026-12-11 23:59 CET (Europe/Rome), 2026-12-11 22:59 UTC",
          "late work: 12.5 % less for each day that has begun; minutes of "
          "grace: 10; days that cost nothing: 2; last day that counts: 7\n",
          "totals: multiples of 0.5", "handed in by: teams",
          "  limits: 2 s for a call, 5 s for a case, 20 s for all; 0.25 s of "
          "CPU in which a case ends or takes more memory; 512 MiB\n"})
        CHECK(contains(said.text, part));
}

TEST_CASE("limits of some exercises are told apart") {
    const Said said = checked(
        "[exercises]\nprev = 1\ntip = 1\nface_sides = 1\n"
        "[limits.tip]\nmemory_mib = 64\n");
    CHECK(said.code == 0);
    CHECK(contains(said.text, "  limits: 2 s for a call"));
    CHECK(contains(said.text, "  limits of tip: 2 s for a call"));
    CHECK(contains(said.text, "takes more memory; 64 MiB\n"));
}

TEST_CASE("every mistake of an assignment is said, with its line") {
    const Said said = checked(
        "due = 2026-03-29T02:30:00\ntime_zone = 'Europe/Rome'\n"
        "rundung = 1\n[exercises]\nface_sids = 1\n");
    INFO(said.text);
    CHECK(said.code == 1);
    for (const char* part : {"week1.toml:1:", "does not exist in Europe/Rome",
                             "week1.toml:3:1:", "'rundung' is not a key",
                             "week1.toml:5:1:", "did you mean face_sides?"})
        CHECK(contains(said.text, part));
}

TEST_CASE("no file is wrong usage") {
    CHECK(grader_says({"assignment", "check", "/no/such.toml"}).code == 2);
    CHECK(grader_says({"assignment"}).code == 2);
}
