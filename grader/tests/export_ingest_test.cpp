// What is taken from the exports of course platforms, as they come.
#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

/// By paths, what is there; each file's bytes are its path.
using Paths = std::vector<std::string>;

SubmittedClass found_in(const std::filesystem::path& place,
                        std::optional<Platform> platform = {}) {
    return find_submissions(place, asked_for, {}, platform);
}

/// The same paths as a folder and as a zip.
class Export {
public:
    explicit Export(const Paths& paths,
                    const std::map<std::string, std::string>& others = {}) {
        std::vector<Packed> entries;
        const auto add = [&](const std::string& path, const std::string& text) {
            disk_.file("folder/" + path, text);
            entries.push_back({path, text});
        };
        for (const std::string& path : paths) add(path, path);
        for (const auto& [path, text] : others) add(path, text);
        disk_.file("export.zip", packed(tests::zip, entries));
    }

    std::vector<std::filesystem::path> places() const {
        return {disk_.at("folder"), disk_.at("export.zip")};
    }

    ClassOnDisk& disk() { return disk_; }

private:
    ClassOnDisk disk_;
};

const Submission& of(const SubmittedClass& all, const std::string& student) {
    for (const Submission& one : all.submissions)
        if (one.student == student) return one;
    FAIL("no submission of " << student);
    return all.submissions[0];
}

std::string bytes(const SubmittedClass& all, const std::string& student,
                  const std::string& file) {
    const auto at = std::find(asked_for.begin(), asked_for.end(), file);
    const auto number = static_cast<std::size_t>(at - asked_for.begin());
    const Submission& one = of(all, student);
    return one.files[number] ? all.bytes(one, number) : "(none)";
}

bool says(const std::vector<std::string>& notes, const std::string& text) {
    return joined(notes).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("Moodle's folders are the submissions of their numbers") {
    const Export moodle({"Anna Rossi_12_assignsubmission_file/prev.cpp",
                         "Anna Rossi_12_assignsubmission_onlinetext/a.html",
                         "Carlo Verdi_13_assignsubmission_file/a/prev.cpp",
                         "Anna Rossi_14_assignsubmission_file_/prev.cpp",
                         "Dora_15_assignsubmission_onlinetext/x.html"});
    for (const auto& place : moodle.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(all.platform == Platform::moodle);
        REQUIRE(all.submissions.size() == 4);
        CHECK(bytes(all, "Anna Rossi_12", "prev.cpp") ==
              "Anna Rossi_12_assignsubmission_file/prev.cpp");
        CHECK(bytes(all, "Carlo Verdi_13", "prev.cpp") ==
              "Carlo Verdi_13_assignsubmission_file/a/prev.cpp");
        CHECK(of(all, "Dora_15").person == "Dora");
        CHECK(of(all, "Dora_15").key == "15");
        CHECK(bytes(all, "Dora_15", "prev.cpp") == "(none)");
        CHECK(says(all.notes, "recognised as an export of Moodle, with 4"));
        CHECK(says(all.notes, "Anna Rossi is the name of 12 and of 14: taken"));
    }
}

TEST_CASE("Moodle's files without folders give the same students") {
    const Export moodle({"Anna Rossi_12_assignsubmission_file_prev.cpp",
                         "Anna Rossi_12_assignsubmission_file_face_sides.cpp",
                         "Carlo_13_assignsubmission_file_notes.txt"});
    for (const auto& place : moodle.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        REQUIRE(all.submissions.size() == 2);
        CHECK(bytes(all, "Anna Rossi_12", "prev.cpp") ==
              "Anna Rossi_12_assignsubmission_file_prev.cpp");
        CHECK(bytes(all, "Anna Rossi_12", "face_sides.cpp") ==
              "Anna Rossi_12_assignsubmission_file_face_sides.cpp");
        CHECK(says(of(all, "Carlo_13").notes, "notes.txt"));
    }
}

TEST_CASE("an archive that Moodle names is opened") {
    const std::string work = packed(tests::zip, {{"prev.cpp", "in it"}});
    Export moodle({"Anna_12_assignsubmission_file/face_sides.cpp"},
                  {{"Carlo_13_assignsubmission_file_work.zip", work}});
    for (const auto& place : moodle.places()) {
        CAPTURE(place);
        CHECK(bytes(found_in(place), "Carlo_13", "prev.cpp") == "in it");
    }
}

TEST_CASE("two places of one number are not mixed") {
    const Export moodle({"Anna B_12_assignsubmission_file/prev.cpp",
                         "Anna R_12_assignsubmission_file/face_sides.cpp"});
    for (const auto& place : moodle.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        REQUIRE(all.submissions.size() == 1);
        CHECK(bytes(all, "Anna B_12", "face_sides.cpp") == "(none)");
        CHECK(says(all.notes,
                   "Anna R_12_assignsubmission_file: ignored, as Anna "
                   "B_12_assignsubmission_file is there as well and counts"));
        CHECK(says(all.notes, "Anna B_12 and Anna R_12 have one number"));
    }
}

TEST_CASE(
    "Canvas's files are sorted by user, and numbers it adds are dropped") {
    const Export canvas(
        {"rossianna_77_4711_prev.cpp", "rossianna_77_4712_face_sides-1.cpp",
         "verdicarlo_LATE_78_4713_prev-12.cpp", "neri_79_text.html"});
    for (const auto& place : canvas.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(all.platform == Platform::canvas);
        REQUIRE(all.submissions.size() == 3);
        CHECK(bytes(all, "rossianna_77", "face_sides.cpp") ==
              "rossianna_77_4712_face_sides-1.cpp");
        CHECK(bytes(all, "verdicarlo_78", "prev.cpp") ==
              "verdicarlo_LATE_78_4713_prev-12.cpp");
        CHECK(of(all, "verdicarlo_78").marked_late);
        CHECK_FALSE(of(all, "rossianna_77").marked_late);
        CHECK(of(all, "neri_79").key == "79");
    }
}

TEST_CASE("of a user's uploads only those of the newest attempt count") {
    const Export canvas({"a_77_900_prev.cpp", "a_77_901_face_sides.cpp",
                         "a_LATE_77_1000_prev-1.cpp", "b_78_9_prev.cpp",
                         "b_78_10_prev-1.cpp"});
    for (const auto& place : canvas.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(bytes(all, "a_77", "prev.cpp") == "a_LATE_77_1000_prev-1.cpp");
        CHECK(bytes(all, "a_77", "face_sides.cpp") == "(none)");
        CHECK(of(all, "a_77").marked_late);
        CHECK(says(of(all, "a_77").notes,
                   "a_77_901_face_sides.cpp: belongs to an earlier attempt"));
        CHECK(bytes(all, "b_78", "prev.cpp") == "b_78_10_prev-1.cpp");
        CHECK(says(of(all, "b_78").notes,
                   "b_78_9_prev.cpp: ignored, as b_78_10_prev-1.cpp was"));
    }
}

TEST_CASE("Gradescope's submissions have the members and times of its file") {
    const std::string root = "assignment_5_export/";
    Export gradescope(
        {root + "submission_101/prev.cpp", root + "submission_102/prev.cpp",
         root + "submission_103/prev.cpp", root + "submission_104/prev.cpp"},
        {{root + "submission_metadata.yml",
          "---\n"
          "submission_101:\n"
          "  :submitters:\n"
          "  - :name: Anna Rossi\n"
          "    :sid: '1001'\n"
          "    :email: anna@example.org\n"
          "  :created_at: 2026-12-10 22:30:00.123456000 Z\n"
          "  :history:\n"
          "  - :id: 7\n"
          "    :created_at: 2026-12-09 08:00:00.000000000 Z\n"
          "submission_102:\n"
          "  :submitters:\n"
          "  - :name: \"Carlo \\\"C\\\" Verdi\"\n"
          "    :sid: 1002\n"
          "  - :name: Dora Neri\n"
          "    :email: dora@example.org\n"
          "  :created_at: 2026-12-11 22:30:00 +0100\n"
          "submission_103:\n"
          "  :submitters:\n"
          "  - {:name: Anna Rossi, :sid: '1001'}\n"
          "  :created_at: 2026-12-12 08:00:00 Z\n"
          "submission_105:\n"
          "  :submitters:\n"
          "  - :name: Enzo\n"}});
    for (const auto& place : gradescope.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(all.platform == Platform::gradescope);
        REQUIRE(all.submissions.size() == 3);
        const Submission& team = of(all, "submission_102");
        CHECK(team.person == "Carlo \"C\" Verdi, Dora Neri");
        REQUIRE(team.members.size() == 2);
        CHECK(team.members[0].number == "1002");
        CHECK(team.members[1].email == "dora@example.org");
        CHECK(text_of(team.submitted_at.value()) == "2026-12-11T21:30:00Z");
        CHECK(of(all, "submission_103").person == "Anna Rossi");
        CHECK(says(all.notes,
                   "submission_101: of Anna Rossi a newer submission, "
                   "submission_103, is there and counts: ignored"));
        CHECK(says(all.notes, "submission_105 of Enzo has no folder"));
        CHECK(bytes(all, "submission_104", "prev.cpp") ==
              root + "submission_104/prev.cpp");
    }
}

TEST_CASE("a broken or missing file of Gradescope costs names and no work") {
    for (const char* text : {"", "- a\n", "a: [\n", "&a [*a, *a]", "\x01",
                             "submission_1: 7\n", "submission_1: {a: b}\n"}) {
        CAPTURE(text);
        Export gradescope({"submission_1/prev.cpp"},
                          {{"submission_metadata.yml", text}});
        for (const auto& place : gradescope.places())
            CHECK(bytes(found_in(place), "submission_1", "prev.cpp") ==
                  "submission_1/prev.cpp");
    }
    const Export without({"submission_1/prev.cpp"});
    for (const auto& place : without.places())
        CHECK(
            says(found_in(place).notes, "submission_metadata.yml: is missing"));
}

TEST_CASE("a deep file of Gradescope ends as a note") {
    Export gradescope(
        {"submission_1/prev.cpp"},
        {{"submission_metadata.yml", std::string(1u << 20, '[')}});
    for (const auto& place : gradescope.places()) {
        const SubmittedClass all = found_in(place);
        CHECK(bytes(all, "submission_1", "prev.cpp") ==
              "submission_1/prev.cpp");
        CHECK(says(all.notes, "names and times are not known"));
    }
}

TEST_CASE("clones of a classroom have a login and the time of the commit") {
    const std::string zeros(40, '0'), hash(40, 'a');
    const auto log = [&](const std::string& what) {
        return zeros + " " + hash + " Eve <a> b@c> 1700000000 +0100\t" + what +
               "\n";
    };
    Export clones(
        {"hw1-anna-r/prev.cpp", "hw1-bob/a/prev.cpp", "hw1-carl/.git/config"},
        {{"hw1-anna-r/.git/logs/HEAD",
          log("clone: from x") + log("commit: done")},
         {"hw1-bob/.git/logs/HEAD", log("clone: from x")}});
    for (const auto& place : clones.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(all.platform == Platform::github);
        REQUIRE(all.submissions.size() == 3);
        CHECK(bytes(all, "anna-r", "prev.cpp") == "hw1-anna-r/prev.cpp");
        CHECK(text_of(of(all, "anna-r").submitted_at.value()) ==
              "2023-11-14T22:13:20Z");
        CHECK_FALSE(of(all, "bob").submitted_at);
        CHECK(of(all, "carl").key == "carl");
    }
}

TEST_CASE("who is not named as the platform does is not dropped") {
    const Export moodle({"A_12_assignsubmission_file/prev.cpp",
                         "B_13_assignsubmission_file/prev.cpp",
                         "Late Larry/prev.cpp", "readme.txt"});
    for (const auto& place : moodle.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        REQUIRE(all.submissions.size() == 3);
        CHECK(bytes(all, "Late Larry", "prev.cpp") == "Late Larry/prev.cpp");
        CHECK(of(all, "Late Larry").key.empty());
        CHECK(says(all.notes,
                   "Late Larry: is not named as Moodle names what was handed "
                   "in; it counts as the submission of Late Larry"));
        CHECK(says(all.notes, "readme.txt: is not named"));
    }
}

TEST_CASE("plain folders stay what they are, and a platform can be forced") {
    const Export plain({"anna/prev.cpp", "bob/prev.cpp",
                        "A_12_assignsubmission_file/prev.cpp"});
    for (const auto& place : plain.places()) {
        CAPTURE(place);
        const SubmittedClass all = found_in(place);
        CHECK(all.platform == Platform::plain);
        CHECK(all.submissions.size() == 3);
        CHECK(all.notes.empty());
        CHECK(of(found_in(place, Platform::moodle), "A_12").key == "12");
        CHECK_THROWS_AS(found_in(place, Platform::canvas), IngestError);
    }
    const Export moodle({"A_12_assignsubmission_file/prev.cpp"});
    for (const auto& place : moodle.places())
        CHECK(found_in(place, Platform::plain).submissions[0].student ==
              "A_12_assignsubmission_file");
}
