// When students handed in: by files, by a table, by Moodle's worksheet.
#include "grader/pipeline/submission_times.h"

#include <fcntl.h>
#include <sys/stat.h>

#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

SubmittedClass class_of(const std::vector<std::string>& names) {
    SubmittedClass all;
    for (const std::string& name : names) {
        all.submissions.emplace_back();
        all.submissions.back().student = name;
        all.submissions.back().id = name;
    }
    return all;
}

std::string time_of(const Submission& one) {
    return one.submitted_at ? text_of(*one.submitted_at) : "unknown";
}

void set_time(const std::filesystem::path& file, std::int64_t seconds) {
    const timespec both[2] = {{seconds, 0}, {seconds, 0}};
    REQUIRE(::utimensat(AT_FDCWD, file.c_str(), both, 0) == 0);
}

}  // namespace

TEST_CASE(
    "a table of two columns gives times by name, with or without header") {
    for (const char* head : {"", "name,time\n"}) {
        SubmittedClass all = class_of({"anna", "bruno", "carla"});
        all.submissions[1].key = "77";
        take_times_from(
            CsvTable(std::string(head) + "anna,2026-12-11T23:59:00\n"
                                         "77,2026-12-11 22:59:30.5 +0000\n"
                                         "nobody,2026-12-11T23:59:00\n"
                                         "carla,tomorrow\n"),
            "Europe/Rome", false, all);
        note_missing_times(all);
        CHECK(time_of(all.submissions[0]) == "2026-12-11T22:59:00Z");
        CHECK(time_of(all.submissions[1]) == "2026-12-11T22:59:30Z");
        CHECK(time_of(all.submissions[2]) == "unknown");
        const std::string notes = joined(all.notes);
        CAPTURE(notes);
        CHECK(notes.find("nobody is the name of 0 submissions") != notes.npos);
        CHECK(notes.find("'tomorrow' is not a time") != notes.npos);
        CHECK(notes.find("counts as in time: carla") != notes.npos);
    }
}

TEST_CASE("a name that two students share gives neither a time") {
    SubmittedClass all = class_of({"anna_1", "anna_2"});
    for (Submission& one : all.submissions) one.person = "anna";
    take_times_from(CsvTable("anna,2026-12-11T23:59:00\nb,2026-12-11\n"), "UTC",
                    false, all);
    for (const Submission& one : all.submissions)
        CHECK(time_of(one) == "unknown");
}

TEST_CASE(
    "Moodle's worksheet gives times by its numbers, and a team's members") {
    const CsvTable worksheet(
        "Identifier,Full name,Group,Last modified (submission)\n"
        "Participant 12,Anna,Blue,\"Friday, 11 December 2026, 11:59 PM\"\n"
        "Participant 13,Bruno,Blue,\"Friday, 11 December 2026, 11:59 PM\"\n"
        "Participant 14,Carla,,-\n");
    SubmittedClass alone = class_of({"a", "b"});
    alone.submissions[0].key = "12";
    alone.submissions[1].key = "13";
    take_times_from(worksheet, "Europe/Rome", false, alone);
    CHECK(time_of(alone.submissions[1]) == "2026-12-11T22:59:00Z");
    CHECK(alone.notes.empty());

    SubmittedClass teams = class_of({"Blue_5"});
    teams.submissions[0].person = "Blue";
    take_times_from(worksheet, "Europe/Rome", true, teams);
    CHECK(time_of(teams.submissions[0]) == "2026-12-11T22:59:00Z");
    REQUIRE(teams.submissions[0].members.size() == 2);
    CHECK((teams.submissions[0].members[1] == Member{"Bruno", "13", ""}));
}

TEST_CASE("another table is refused") {
    SubmittedClass all = class_of({"anna"});
    CHECK_THROWS_AS(
        take_times_from(CsvTable("a,b,c\n1,2,3\n"), "UTC", false, all),
        CsvError);
}

TEST_CASE("the newest file that counts tells when a folder came") {
    ClassOnDisk disk;
    disk.file("anna/prev.cpp").file("anna/face_sides.cpp").file("anna/a.txt");
    set_time(disk.at("anna/prev.cpp"), 1'700'000'000);
    set_time(disk.at("anna/face_sides.cpp"), 1'700'000'060);
    SubmittedClass all = find_submissions(disk.at("."), asked_for);
    take_times_of_files(all, "Europe/Rome");
    CHECK(time_of(all.submissions[0]) == "2023-11-14T22:14:20Z");
}

TEST_CASE("a zip's times are by the clocks of the zone, a tar's are not") {
    // libarchive writes the time of an entry that has none as 1980.
    ClassOnDisk disk;
    disk.file("c.zip", packed(tests::zip, {{"anna/prev.cpp"}}));
    SubmittedClass all = find_submissions(disk.at("c.zip"), asked_for);
    REQUIRE(all.submissions[0].modified.size() == 1);
    SubmittedClass rome = class_of({"anna"});
    rome.submissions[0].modified = {{1'796'000'000, true}};
    take_times_of_files(rome, "Europe/Rome");
    SubmittedClass utc = class_of({"anna"});
    utc.submissions[0].modified = {{1'796'000'000, false}};
    take_times_of_files(utc, "Europe/Rome");
    CHECK(*utc.submissions[0].submitted_at -
              *rome.submissions[0].submitted_at ==
          std::chrono::hours(1));
}

TEST_CASE("a zip's clock in the hour that spring skips is taken as before") {
    SubmittedClass all = class_of({"anna"});
    // 2026-03-29 02:30 on the clock, which Rome's clocks do not show.
    all.submissions[0].modified = {{1'774'751'400, true}};
    take_times_of_files(all, "Europe/Rome");
    CHECK(time_of(all.submissions[0]) == "2026-03-29T01:30:00Z");
}
