// Hostile archives: each is refused with a reason, harms nobody else, and
// leaves nothing on the disk.
#include "grader/tests/class_on_disk.h"
#include "grader/tests/hostile_archives.h"

using namespace grader;
using namespace grader::tests;

namespace {

const std::vector<HostileArchive>& corpus() {
    static const std::vector<HostileArchive> all = hostile_archives();
    return all;
}

/// What is said of it: that of an honest file beside it is taken as always.
void check_in_a_folder(const HostileArchive& one) {
    ClassOnDisk all;
    all.file("anna/" + one.name, one.bytes).file("anna/prev.cpp", "honest");
    all.file("bruno/face_sides.cpp", "honest");
    const std::set<std::string> before = all.contents();
    const ClassHandedIn found = all.find();
    CHECK(all.contents() == before);
    REQUIRE(found.submissions.size() == 2);
    const HandedIn& anna = found.submissions[0];
    REQUIRE(anna.files.size() == 1);
    CHECK(anna.files.at("prev.cpp") == "honest");
    CHECK(found.submissions[1].files.at("face_sides.cpp") == "honest");
    INFO(joined(anna.notes));
    CHECK(joined(anna.notes).find(one.note) != std::string::npos);
    CHECK(found.notes.empty());
}

}  // namespace

TEST_CASE("the corpus is large") {
    CHECK(corpus().size() >= 40);
}

TEST_CASE("a hostile archive in a student's folder is refused with a reason") {
    for (const HostileArchive& one : corpus()) {
        CAPTURE(one.what);
        check_in_a_folder(one);
    }
}

TEST_CASE("a hostile archive beside the folders is its student's loss only") {
    for (const HostileArchive& one : corpus()) {
        CAPTURE(one.what);
        ClassOnDisk all;
        all.file(one.name, one.bytes).file("bruno/face_sides.cpp", "honest");
        const ClassHandedIn found = all.find();
        REQUIRE(found.submissions.size() == 2);
        CHECK(found.submissions[0].student == "a");
        CHECK(found.submissions[0].files.empty());
        CHECK(found.submissions[0].notes.size() >= 1);
        CHECK(found.submissions[1].files.size() == 1);
    }
}

TEST_CASE("a hostile archive of a class is an error or harmless") {
    for (const HostileArchive& one : corpus()) {
        CAPTURE(one.what);
        ClassOnDisk all;
        all.file(one.name, one.bytes);
        const std::set<std::string> before = all.contents();
        try {
            for (const HandedIn& s : all.find(one.name).submissions)
                CHECK(s.files.empty());
        } catch (const IngestError& error) {
            CHECK_THAT(error.what(), Containing(one.name + ": "));
            CHECK_THAT(error.what(), Containing("as a whole or not at all"));
        }
        CHECK(all.contents() == before);
    }
}

TEST_CASE("a hostile archive in the archive of a class harms nobody else") {
    ArchiveWriter writer(tar_zst);
    const auto is_small = [](const HostileArchive& one) {
        return one.bytes.size() < (1u << 20);
    };
    int k = 0;
    for (const HostileArchive& one : corpus())
        if (is_small(one))
            writer.add({std::to_string(k++) + "/" + one.name, one.bytes});
    writer.add({"honest/face_sides.cpp", "honest"});
    ClassOnDisk all;
    all.file("class.tar.zst", writer.finish());
    const ClassHandedIn found = all.find("class.tar.zst");
    CHECK(found.submissions.size() == static_cast<std::size_t>(k + 1));
    for (const HandedIn& one : found.submissions) {
        CAPTURE(one.student);
        CHECK(one.files.size() == (one.student == "honest" ? 1 : 0));
        CHECK(one.notes.empty() == (one.student == "honest"));
    }
}

TEST_CASE("setuid bits and owners are nothing but numbers") {
    ClassOnDisk all;
    all.file("anna/a.tar",
             packed(tar, {{"prev.cpp", "mine", AE_IFREG, 06755}}));
    CHECK(all.only().files.at("prev.cpp") == "mine");
}

TEST_CASE("a file that follows a link of its name is taken as data") {
    ClassOnDisk all;
    all.file("anna/a.tar", tar_of({{"prev.cpp", '2', "", "/etc/passwd"},
                                   {"prev.cpp", '0', "mine"}}));
    CHECK(all.only().files.at("prev.cpp") == "mine");
    CHECK(joined(all.only().notes) ==
          "a.tar/prev.cpp: is a symbolic link: refused\n");
}

TEST_CASE("what is refused in the archive of a class stands with its student") {
    ClassOnDisk all;
    all.file("class.tar",
             tar_of({{"anna/prev.cpp"},
                     {"anna/../bruno/prev.cpp", '0', "forged"},
                     {"carla/face_sides.cpp", '2', "", "../anna/prev.cpp"},
                     {"../prev.cpp"},
                     {"mallory", '2', "", "anna"}}));
    const ClassHandedIn found = all.find("class.tar");
    REQUIRE(found.submissions.size() == 2);
    CHECK(joined(found.submissions[0].notes) ==
          "../bruno/prev.cpp: leads out of its folder by \"..\": refused\n");
    CHECK(joined(found.submissions[1].notes) ==
          "face_sides.cpp: is a symbolic link: refused\n");
    CHECK(joined(found.notes) ==
          "../prev.cpp: leads out of its folder by \"..\": refused\n"
          "mallory: is a symbolic link: refused\n");
}

TEST_CASE("an archive of a class that is cut short grades nobody") {
    const std::string whole = packed(
        zip, {{"anna/prev.cpp"}, {"bruno/prev.cpp"}, {"carla/prev.cpp"}});
    const std::string tarred = tar_of({{"anna/prev.cpp"},
                                       {"bruno/prev.cpp"},
                                       {"carla/prev.cpp", '0', "01234567"}});
    ClassOnDisk all;
    all.file("class.zip", whole.substr(0, whole.size() - 40))
        .file("class.tar", tarred.substr(0, 2 * 1024 + 512 + 4));
    CHECK_THROWS_AS(all.find("class.zip"), IngestError);
    try {
        all.find("class.tar");
        FAIL("nothing was thrown");
    } catch (const IngestError& error) {
        CHECK_THAT(error.what(), Containing("class.tar: entry 3: "));
    }
}

TEST_CASE("the archive of a class has limits of its own") {
    ClassOnDisk all;
    all.file("class.tar.gz", packed(tar_gz, {{"anna/prev.cpp", "1"},
                                             {"anna/x", "22222222"},
                                             {"bruno/prev.cpp", "3"}}));
    IngestLimits limits;
    limits.class_entries = 2;
    CHECK_THROWS_AS(all.find("class.tar.gz", limits), IngestError);
    limits.class_entries = 3;
    CHECK(all.find("class.tar.gz", limits).submissions.size() == 2);
    limits.class_bytes = 1000;
    CHECK_THROWS_AS(all.find("class.tar.gz", limits), IngestError);
}

TEST_CASE("the limits of a student hold over all archives together") {
    ClassOnDisk all;
    IngestLimits limits;
    limits.total_bytes = 10;
    all.file("anna/a.zip", packed(zip, {{"prev.cpp", "123456"}}))
        .file("anna/b.zip", packed(zip, {{"face_sides.cpp", "123456"}}));
    CHECK(all.only(limits).files.size() == 1);
    CHECK_THAT(joined(all.only(limits).notes),
               Containing("b.zip/face_sides.cpp: at most 10 bytes"));
    limits = {};
    limits.archives = 1;
    CHECK(joined(all.only(limits).notes) ==
          "b.zip: at most 1 archives of a student are opened: refused\n");
    limits = {};
    limits.archive_bytes = 5;
    CHECK_THAT(joined(all.only(limits).notes), Containing("at most 5 are"));
    limits = {};
    limits.entries = 3;
    CHECK(all.only(limits).files.size() == 1);
}

TEST_CASE("an archive with one name many times does not fill the disk") {
    ArchiveWriter writer(tar_gz);
    for (int k = 10; k < 60; ++k) writer.add({"prev.cpp", std::to_string(k)});
    ClassOnDisk all;
    all.file("anna/a.tgz", writer.finish());
    IngestLimits limits;
    limits.written_bytes = 10;
    const SubmittedClass found =
        find_submissions(all.at("."), {"prev.cpp"}, limits);
    const Submission& anna = found.submissions.at(0);
    CHECK(anna.files[0]->offset + anna.files[0]->size == 10);
    CHECK(found.bytes(anna, 0) == "14");
    CHECK_THAT(joined(anna.notes),
               Containing("a.tgz/prev.cpp: at most 10 bytes of a student are "
                          "taken in all, with files that others of their name "
                          "replaced, and this file has 2 more: refused"));
}

TEST_CASE("files that fit are taken whatever was replaced before them") {
    ClassOnDisk all;
    all.file("anna/a.zip", packed(zip, {{"x/prev.cpp", "12345678"}}))
        .file("anna/b/prev.cpp", "abcdefgh");
    IngestLimits limits;
    limits.total_bytes = 10;
    CHECK(all.only(limits).files.at("prev.cpp") == "abcdefgh");
}

TEST_CASE("entries of one student in the archive of a class are limited") {
    ArchiveWriter writer(tar_gz);
    for (int k = 0; k < 50; ++k) writer.add({"anna/" + std::to_string(k), "x"});
    writer.add({"anna/prev.cpp"}).add({"bruno/prev.cpp"});
    ClassOnDisk all;
    all.file("class.tgz", writer.finish());
    IngestLimits limits;
    limits.entries = 50;
    const ClassHandedIn found = all.find("class.tgz", limits);
    CHECK(found.submissions[0].files.empty());
    CHECK_THAT(joined(found.submissions[0].notes),
               Containing("what follows in the archive was left out"));
    CHECK(found.submissions[1].files.size() == 1);
}

TEST_CASE("a flood of refusals in an archive gives a few notes") {
    std::vector<TarPart> links;
    for (int k = 0; k < 500; ++k)
        links.push_back({std::to_string(k), '2', "", "/"});
    ClassOnDisk all;
    all.file("anna/a.tar", tar_of(links));
    REQUIRE(all.only().notes.size() == 41);
    CHECK(all.only().notes.back() == "and 460 more notes");
}

TEST_CASE("what is neither a folder nor an archive is no class") {
    ClassOnDisk all;
    all.file("class.rar", "x");
    CHECK_THROWS_AS(all.find("class.rar"), IngestError);
    REQUIRE(::mkfifo(all.at("class.zip").c_str(), 0600) == 0);
    CHECK_THROWS_AS(all.find("class.zip"), IngestError);
}
