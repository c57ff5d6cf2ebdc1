// Archives that honest students and teachers hand in: of one student, beside
// the students' folders, and of a whole class.
#include <algorithm>
#include <clocale>

#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

struct Kind {
    const char* ending;
    Maker maker;
};

const std::vector<Kind> kinds = {
    {".zip", zip},       {".tar", tar},         {".tar", gnu_tar},
    {".tar.gz", tar_gz}, {".tgz", tar_gz},      {".tar.bz2", tar_bz2},
    {".tar.xz", tar_xz}, {".tar.zst", tar_zst}, {".ZIP", zip},
    {".tar.xz", tar_gz},  // as its bytes tell
};

const std::vector<Packed> homework = {
    {"week1/", "", AE_IFDIR, 0755},
    {"week1/face_sides.cpp", "one"},
    {"week1/notes.txt", "two"},
    {"prev.cpp", "three"},
    {"week1/a/b/boundary_walk.cpp", "too deep"}};

/// The same entries as a folder on disk would hold, below `folder`.
void unpack(ClassOnDisk& to, const std::string& folder,
            const std::vector<Packed>& entries) {
    for (const Packed& entry : entries)
        if (entry.type == AE_IFREG) to.file(folder + entry.path, entry.bytes);
}

void check_same(const ClassHandedIn& a, const ClassHandedIn& b) {
    REQUIRE(a.submissions.size() == b.submissions.size());
    for (std::size_t k = 0; k < a.submissions.size(); ++k) {
        const HandedIn &x = a.submissions[k], &y = b.submissions[k];
        CHECK(x.student == y.student);
        CHECK(x.id == y.id);
        CHECK(joined(x.notes) == joined(y.notes));
        CHECK(x.files == y.files);
    }
    CHECK(joined(a.notes) == joined(b.notes));
}

}  // namespace

TEST_CASE("an archive in a student's folder counts as a folder of its name") {
    for (const Kind& kind : kinds) {
        CAPTURE(kind.ending);
        const std::string name = std::string("homework") + kind.ending;
        ClassOnDisk all, same;
        all.file("anna/" + name, packed(kind.maker, homework));
        unpack(same, "anna/" + name + "/", homework);
        check_same(all.find(), same.find());
        CHECK(all.only().files.at("face_sides.cpp") == "one");
        CHECK(all.only().files.at("prev.cpp") == "three");
        CHECK(joined(all.only().notes) ==
              name +
                  "/week1/a/b/: lies more than 3 folders deep: not looked at\n"
                  "ignored, as no exercise asks for them: " +
                  name + "/week1/notes.txt\n");
    }
}

TEST_CASE("an archive of a class is as if it were unpacked") {
    const std::vector<Packed> entries = {
        {"anna/", "", AE_IFDIR, 0755},
        {"bruno/", "", AE_IFDIR, 0755},
        {"anna/a/b/c/prev.cpp", "deep"},
        {"anna/z/prev.cpp", "z"},
        {"anna/b/prev.cpp", "b"},
        {"carla/Face_Sides.cpp", "near"},
        {"carla/Makefile", "x"},
        {"carla/.git/config", "x"},
        {"carla/__MACOSX/prev.cpp", "not this"},
        {"carla/a/b/c/d/prev.cpp", "too deep"},
        {"=cmd()/prev.cpp", "x"},
        {"prev.cpp", "nobody's"},
        {".DS_Store", "x"},
        {"__MACOSX/anna/prev.cpp", "not this"}};
    for (const Kind& kind : kinds) {
        CAPTURE(kind.ending);
        const std::string name = std::string("class") + kind.ending;
        ClassOnDisk all, same;
        all.file(name, packed(kind.maker, entries));
        std::filesystem::create_directories(same.at("bruno"));
        unpack(same, "", entries);
        ClassHandedIn folder = same.find(), archive = all.find(name);
        std::sort(archive.notes.begin(), archive.notes.end());
        check_same(archive, folder);
        CHECK(archive.submissions.size() == 4);
        CHECK(archive.submissions[0].files.at("prev.cpp") == "b");
    }
}

TEST_CASE("students' archives in the archive of a class are opened") {
    ClassOnDisk all;
    all.file("class.zip",
             packed(zip, {{"anna/homework.tar.gz", packed(tar_gz, homework)},
                          {"bruno.zip", packed(zip, homework)},
                          {"carla/x.zip", "broken"}}));
    const ClassHandedIn found = all.find("class.zip");
    REQUIRE(found.submissions.size() == 3);
    CHECK(found.submissions[0].files.at("prev.cpp") == "three");
    CHECK(found.submissions[1].student == "bruno");
    CHECK(found.submissions[1].files.at("face_sides.cpp") == "one");
    CHECK_THAT(joined(found.submissions[2].notes),
               Containing("x.zip: it is no zip file or cut short"));
}

TEST_CASE("an archive in a student's archive is not opened") {
    ClassOnDisk all;
    all.file("anna/a.zip",
             packed(zip, {{"b.zip", packed(zip, homework)}, {"prev.cpp"}}));
    CHECK(all.only().files.size() == 1);
    CHECK(joined(all.only().notes) ==
          "a.zip/b.zip: is an archive in an archive: not opened\n");
}

TEST_CASE("an archive beside the folders is the submission of its student") {
    ClassOnDisk all;
    all.file("anna.zip", packed(zip, homework)).file("bruno/prev.cpp");
    const ClassHandedIn found = all.find();
    REQUIRE(found.submissions.size() == 2);
    CHECK(found.submissions[0].student == "anna");
    CHECK(found.submissions[0].files.at("prev.cpp") == "three");
    CHECK(found.notes.empty());
}

TEST_CASE("of a folder and archives of one student the folder counts") {
    const std::string text =
        "anna.tar: ignored, as the folder anna/ is there as well and counts\n"
        "anna.zip: ignored, as the folder anna/ is there as well and counts\n";
    ClassOnDisk all;
    all.file("anna.zip", packed(zip, {{"prev.cpp", "in the zip"}}))
        .file("anna.tar", packed(tar, homework))
        .file("anna/prev.cpp", "mine");
    CHECK(all.only().files.size() == 1);
    CHECK(all.only().files.at("prev.cpp") == "mine");
    CHECK(joined(all.only().notes) == text);
    CHECK(joined(all.find().notes) == text);
    std::filesystem::remove_all(all.at("anna"));
    CHECK(all.only().files.at("prev.cpp") == "three");
    CHECK(joined(all.only().notes) ==
          "anna.tar/week1/a/b/: lies more than 3 folders deep: not looked at\n"
          "anna.zip: ignored, as anna.tar is there as well and counts\n"
          "ignored, as no exercise asks for them: anna.tar/week1/notes.txt\n");
}

TEST_CASE("notes on archives that do not count are in the archives' order") {
    ClassOnDisk all;
    all.file("anna.tar", packed(tar, homework))
        .file("anna/prev.cpp")
        .file("anna-b.zip", packed(zip, homework))
        .file("anna-b/prev.cpp")
        .file("zoe");
    CHECK(joined(all.find().notes) ==
          "zoe: ignored; expected a folder for each student\n"
          "anna-b.zip: ignored, as the folder anna-b/ is there as well and "
          "counts\n"
          "anna.tar: ignored, as the folder anna/ is there as well and "
          "counts\n");
}

TEST_CASE("of a file in a folder and one in an archive the less deep counts") {
    ClassOnDisk all;
    all.file("anna/a.zip", packed(zip, {{"prev.cpp", "in the archive"},
                                        {"x/face_sides.cpp", "deep"}}))
        .file("anna/b/face_sides.cpp", "folder")
        .file("anna/b/prev.cpp", "folder");
    const HandedIn anna = all.only();
    CHECK(anna.files.at("prev.cpp") == "in the archive");
    CHECK(anna.files.at("face_sides.cpp") == "folder");
    CHECK(joined(anna.notes) ==
          "face_sides.cpp is there 2 times: b/face_sides.cpp was taken, "
          "ignored: a.zip/x/face_sides.cpp\n"
          "prev.cpp is there 2 times: a.zip/prev.cpp was taken, ignored: "
          "b/prev.cpp\n");
}

TEST_CASE("names stay the bytes that they are, composed or not") {
    const std::vector<Packed> entries = {
        {"Anna/prev.cpp", "1"},        {"anna/prev.cpp", "2"},
        {"\xC3\x84nna/prev.cpp", "3"}, {"A\xCC\x88nna/prev.cpp", "4"},
        {"\xff\xfe/prev.cpp", "5"},    {"\xE2\x80\xAEgpj/prev.cpp", "6"},
        {"a\nb/prev.cpp", "7"},        {"-rf/prev.cpp", "8"},
        {"=cmd|x/prev.cpp", "9"},      {"CON/prev.cpp", "10"},
        {"NUL.txt/prev.cpp", "11"},    {"dots.../prev.cpp", "12"},
        {" /prev.cpp", "13"},          {"<b>&/prev.cpp", "14"}};
    std::vector<ZipPart> parts;
    for (const Packed& entry : entries)  // as UTF-8, whether it is or not
        parts.push_back({entry.path, entry.bytes});
    for (ZipPart& part : parts) part.flags = 0x800;
    for (const auto& [name, bytes] :
         {std::pair<std::string, std::string>{"class.zip", zip_of(parts)},
          {"class.tar", packed(gnu_tar, entries)}}) {
        CAPTURE(name);
        ClassOnDisk all, same;
        all.file(name, bytes);
        unpack(same, "", entries);
        check_same(all.find(name), same.find());
        CHECK(all.find(name).submissions.size() == entries.size());
    }
}

TEST_CASE("composed and decomposed names stay two in a pax header") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "C.UTF-8");
    std::string bytes;
    for (const char* path : {"\xC3\x84nna/prev.cpp", "A\xCC\x88nna/prev.cpp"})
        bytes += tar_part({"x", 'x', pax_record("path", path)}) +
                 tar_part({"short"});
    ClassOnDisk all;
    all.file("class.tar", bytes + std::string(1024, '\0'));
    const ClassHandedIn found = all.find("class.tar");
    std::setlocale(LC_ALL, before.c_str());
    REQUIRE(found.submissions.size() == 2);
    CHECK(found.submissions[0].student != found.submissions[1].student);
}

TEST_CASE("what tar writes for a folder in which it runs is understood") {
    ClassOnDisk all;
    all.file("anna/a.tgz", packed(tar_gz, {{"./", "", AE_IFDIR, 0755},
                                           {"./prev.cpp", "here"},
                                           {"./w/face_sides.cpp"}}));
    CHECK(all.only().files.size() == 2);
    CHECK(all.only().files.at("prev.cpp") == "here");
    CHECK(all.only().notes.empty());
}

TEST_CASE("a zip may have something before it, as one that unpacks itself") {
    ClassOnDisk all;
    all.file("anna/a.zip", "MZ and a program" + zip_of({{"prev.cpp", "mine"}}));
    CHECK(all.only().files.at("prev.cpp") == "mine");
}

TEST_CASE("a stored entry ends where the zip's directory says") {
    ZipPart part = {"prev.cpp", "as much as PK\7\b this"};
    part.flags = 8;  // its size follows it, in a record that begins so
    ClassOnDisk all;
    all.file("anna/a.zip", zip_of({part, {"face_sides.cpp", "other"}}));
    CHECK(all.only().files.at("prev.cpp") == part.bytes);
    CHECK(all.only().files.at("face_sides.cpp") == "other");
}

TEST_CASE("of one path twice in an archive the last counts, with a note") {
    const std::vector<Packed> twice = {{"prev.cpp", "old"},
                                       {"prev.cpp", "new"}};
    for (const char* name : {"a.zip", "a.tar"}) {
        ClassOnDisk all;
        all.file(std::string("anna/") + name,
                 packed(name == std::string("a.zip") ? zip : tar, twice));
        CHECK(all.only().files.at("prev.cpp") == "new");
        CHECK(joined(all.only().notes) ==
              std::string(name) +
                  "/prev.cpp: is in the archive more than once: the last of "
                  "them counts\n");
    }
}

TEST_CASE("a path that is a file and a folder at once is both") {
    ClassOnDisk all;
    all.file("anna/a.zip", packed(zip, {{"prev.cpp", "file"},
                                        {"prev.cpp/face_sides.cpp", "in"}}));
    CHECK(all.only().files.at("prev.cpp") == "file");
    CHECK(all.only().files.at("face_sides.cpp") == "in");
}

TEST_CASE("a zip64 archive with honest numbers is read") {
    ZipBody body = zip_body({{"prev.cpp", "mine"}});
    const std::uint64_t at = body.bytes.size();
    body.end.before = "PK\6\6" + little(44, 8) + little(45, 2) + little(45, 2) +
                      little(0, 8) + little(1, 8) + little(1, 8) +
                      little(body.end.size, 8) + little(body.end.offset, 8) +
                      "PK\6\7" + little(0, 4) + little(at, 8) + little(1, 4);
    body.end.entries = 0xffff;
    body.end.size = body.end.offset = 0xffffffff;
    ClassOnDisk all;
    all.file("anna/a.zip", body.bytes + zip_end(body.end));
    CHECK(joined(all.only().notes).empty());
    CHECK(all.only().files.at("prev.cpp") == "mine");
}

TEST_CASE(
    "a file that an exercise asks for is no archive, nor is a hidden one") {
    ClassOnDisk all;
    all.file("anna/answer.zip", packed(zip, homework))
        .file("anna/._homework.zip", "Mac OS X");
    const std::vector<std::string> names = {"answer.zip", "prev.cpp"};
    const ClassHandedIn found =
        with_bytes(find_submissions(all.at("."), names), names);
    REQUIRE(found.submissions.size() == 1);
    CHECK(found.submissions[0].files.size() == 1);
    CHECK(found.submissions[0].files.at("answer.zip") == packed(zip, homework));
    CHECK(joined(found.submissions[0].notes) ==
          "ignored, as no exercise asks for them: ._homework.zip\n");
}

TEST_CASE("a class of 5000 students in one archive") {
    ArchiveWriter writer(tar_gz);
    for (int k = 0; k < 5000; ++k)
        writer.add(
            {"student " + std::to_string(k) + "/prev.cpp", std::to_string(k)});
    ClassOnDisk all;
    all.file("class.tar.gz", writer.finish());
    const ClassHandedIn found = all.find("class.tar.gz");
    REQUIRE(found.submissions.size() == 5000);
    std::set<std::string> ids;
    for (const HandedIn& one : found.submissions) {
        ids.insert(one.id);
        CHECK("student " + one.files.at("prev.cpp") == one.student);
    }
    CHECK(ids.size() == 5000);
}
