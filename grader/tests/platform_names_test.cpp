// Names in the exports of Moodle, Canvas and Gradescope.
#include "grader/pipeline/platform_names.h"

#include <string_view>

#include "course/runner/catch2.h"

using namespace grader;

TEST_CASE("Moodle's folders have a name and its number") {
    for (const char* entry : {"Anna Rossi_1234_assignsubmission_file",
                              "Anna Rossi_1234_assignsubmission_file_",
                              "Anna Rossi_1234_assignsubmission_onlinetext"}) {
        CAPTURE(entry);
        const auto name = parse_moodle(entry);
        REQUIRE(name);
        CHECK(name->person == "Anna Rossi");
        CHECK(name->key == "1234");
        CHECK(name->file.empty());
        CHECK(name->kind == (std::string_view(entry).ends_with("text")
                                 ? "onlinetext"
                                 : "file"));
    }
}

TEST_CASE("Moodle's files without folders have the student's file name") {
    const auto name = parse_moodle(
        "Anna Rossi_1234_assignsubmission_file_my_99_assignsubmission_file_x");
    REQUIRE(name);
    CHECK(*name == PlatformName{"Anna Rossi", "1234", false,
                                "my_99_assignsubmission_file_x", "", "file"});
}

TEST_CASE("Moodle's hidden names are told apart by their number") {
    const auto name = parse_moodle("Participant_77_assignsubmission_file");
    REQUIRE(name);
    CHECK(name->person == "Participant 77");
    CHECK(name->key == "77");
}

TEST_CASE("Moodle's teams have the group's name and number, or no number") {
    const auto team = parse_moodle("Team 3 _ blue_58_assignsubmission_file");
    REQUIRE(team);
    CHECK(team->person == "Team 3 _ blue");
    CHECK(team->key == "58");
    const auto rest = parse_moodle("Default group_assignsubmission_file");
    REQUIRE(rest);
    CHECK(rest->person == "Default group");
    CHECK(rest->key.empty());
}

TEST_CASE("Canvas's files have person, late mark, user, upload and name") {
    CHECK(parse_canvas("rossianna_77_4711_prev.cpp") ==
          PlatformName{"rossianna", "77", false, "prev.cpp", "4711"});
    CHECK(parse_canvas("rossianna_LATE_77_4711_face_sides-1.cpp") ==
          PlatformName{"rossianna", "77", true, "face_sides-1.cpp", "4711"});
    CHECK(parse_canvas("rossianna_late_77_4711_1_2_a.cpp") ==
          PlatformName{"rossianna", "77", true, "1_2_a.cpp", "4711"});
    CHECK(parse_canvas("rossianna_77_text.html") ==
          PlatformName{"rossianna", "77", false, "text.html", ""});
    CHECK(parse_canvas("platelate_77_4711_a") ==
          PlatformName{"platelate", "77", false, "a", "4711"});
}

TEST_CASE("Canvas's hidden names have an id that is no number") {
    CHECK(parse_canvas("anon_Xy1z2_4711_prev.cpp") ==
          PlatformName{"anon_Xy1z2", "Xy1z2", false, "prev.cpp", "4711"});
    CHECK(parse_canvas("LATE_anon_Xy1z2_4711_prev.cpp") ==
          PlatformName{"anon_Xy1z2", "Xy1z2", true, "prev.cpp", "4711"});
    CHECK(parse_canvas("anon_LATE_12345_4711_prev.cpp") ==
          PlatformName{"anon_12345", "12345", true, "prev.cpp", "4711"});
}

TEST_CASE("Gradescope's folders have the number of the submission") {
    CHECK(parse_gradescope("submission_123456") ==
          PlatformName{"", "123456", false, ""});
    CHECK_FALSE(parse_gradescope("submission_"));
    CHECK_FALSE(parse_gradescope("submission_12a"));
    CHECK_FALSE(parse_gradescope("submission_12/a"));
}

TEST_CASE("other names are no platform's") {
    for (const char* entry :
         {"", "_", "anna", "anna_rossi", "Anna Rossi", "anna.zip", "a_1_b.cpp",
          "Anna_12_assignsubmission_", "Anna_12_assignsubmission",
          "Anna_12assignsubmission_file", "Anna_12_assignsubmission_file-2",
          "a_1_2_", "anon_", "late_", "anon_1_2", "homework_2_3.cpp"}) {
        CAPTURE(entry);
        CHECK_FALSE(parse_moodle(entry));
        CHECK_FALSE(parse_canvas(entry));
        CHECK_FALSE(parse_gradescope(entry));
    }
}
