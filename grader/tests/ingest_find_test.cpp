// What is taken from the students' folders, and what is refused.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

/// In MiB.
long peak_of_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

/// By how many MiB the peak grows where a class is found.
long growth_by(const std::filesystem::path& students) {
    const long before = peak_of_memory();
    const SubmittedClass all = find_submissions(students, asked_for);
    return peak_of_memory() - before;
}

/// The same in a process of its own, as a peak is not forgotten.
int memory_for(const std::filesystem::path& students) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr long most = 255;  // that an exit code can say; and a failure
        try {
            ::_exit(static_cast<int>(std::min(growth_by(students), most)));
        } catch (...) {
            ::_exit(most);
        }
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("files are found by name in at most three folders") {
    ClassOnDisk all;
    all.file("anna/face_sides.cpp", "one")
        .file("anna/a/prev.cpp", "two")
        .file("anna/a/b/c/boundary_walk.cpp", "three")
        .file("anna/a/b/c/d/complete_table.csv", "too deep");
    const HandedIn anna = all.only();
    REQUIRE(anna.files.size() == 3);
    CHECK(anna.files.at("face_sides.cpp") == "one");
    CHECK(anna.files.at("prev.cpp") == "two");
    CHECK(anna.files.at("boundary_walk.cpp") == "three");
    CHECK(joined(anna.notes) ==
          "a/b/c/d/: lies more than 3 folders deep: not looked at\n");
}

TEST_CASE("an empty folder is a submission without files") {
    ClassOnDisk all;
    all.empty("carla");
    CHECK(all.only().files.empty());
    CHECK(all.only().notes.empty());
    CHECK(all.only().student == "carla");
}

TEST_CASE("bytes are taken as they are") {
    const std::string bytes("\xff\0\r\n\x1b<b>", 8);
    ClassOnDisk all;
    all.file("anna/prev.cpp", bytes).file("anna/face_sides.cpp", "");
    CHECK(all.only().files.at("prev.cpp") == bytes);
    CHECK(all.only().files.at("face_sides.cpp").empty());
}

TEST_CASE("of two files of a name the least deep is taken, then the first") {
    ClassOnDisk all;
    all.file("anna/b/prev.cpp", "b")
        .file("anna/a/prev.cpp", "a")
        .file("anna/c/prev.cpp", "c")
        .file("anna/d/prev.cpp", "d")
        .file("anna/a/old/face_sides.cpp", "old")
        .file("anna/z/face_sides.cpp", "new");
    const HandedIn anna = all.only();
    CHECK(anna.files.at("prev.cpp") == "a");
    CHECK(anna.files.at("face_sides.cpp") == "new");
    CHECK(joined(anna.notes) ==
          "face_sides.cpp is there 2 times: z/face_sides.cpp was taken, "
          "ignored: a/old/face_sides.cpp\n"
          "prev.cpp is there 4 times: a/prev.cpp was taken, ignored: "
          "b/prev.cpp, c/prev.cpp, d/prev.cpp\n");
}

TEST_CASE("names that are nearly right are not taken, but asked about") {
    for (const char* name :
         {"Face_Sides.cpp", "face_sides (1).cpp", "face_sides.cpp.txt",
          "faces_sides.cpp", "face-sides.cpp", "face sides.cpp",
          "face_sides - Copy.cpp", "face_sides_copia.cpp", "face_sides2.cpp",
          "facesides.cpp", "face_sides.cc", "face_sides.CPP", "face_sides",
          "face_side.cpp", "Face_Sides(12).cpp"}) {
        CAPTURE(name);
        ClassOnDisk all;
        all.file("anna/week 1/" + std::string(name));
        CHECK(all.only().files.empty());
        CHECK(joined(all.only().notes) ==
              "week 1/" + std::string(name) +
                  ": ignored, as file names must be exact; did you mean "
                  "face_sides.cpp?\n");
    }
}

TEST_CASE("other files are named, and no question is asked about them") {
    ClassOnDisk all;
    all.file("anna/prev.cpp", "mine")
        .file("anna/face_sides.h")
        .file("anna/Makefile")
        .file("anna/next.cpp")
        .file("anna/face_sides_test.cpp")
        .file("anna/.git/config")
        .file("anna/__MACOSX/prev.cpp", "not this one");
    const HandedIn anna = all.only();
    CHECK(anna.files.size() == 1);
    CHECK(anna.files.at("prev.cpp") == "mine");
    CHECK(joined(anna.notes) ==
          "ignored, as no exercise asks for them: .git/, Makefile, "
          "__MACOSX/, face_sides.h, face_sides_test.cpp, next.cpp\n");
}

TEST_CASE("links are never followed") {
    ClassOnDisk all, secret;
    secret.file("s/prev.cpp", "secret");
    all.link("anna/prev.cpp", secret.at("s/prev.cpp"))
        .link("anna/face_sides.cpp", "prev.cpp")
        .link("anna/folder", secret.at("s"))
        .link("anna/loop", ".");
    const HandedIn anna = all.only();
    CHECK(anna.files.empty());
    CHECK(anna.notes.size() == 4);
    for (const std::string& note : anna.notes)
        CHECK_THAT(note, Containing("is a symbolic link"));
}

TEST_CASE("a student's folder that is a link is no submission") {
    ClassOnDisk all, secret;
    secret.file("s/prev.cpp", "secret");
    all.link("mallory", secret.at("s")).file("anna/prev.cpp");
    const ClassHandedIn found = all.find();
    REQUIRE(found.submissions.size() == 1);
    CHECK(found.submissions[0].student == "anna");
    CHECK_THAT(joined(found.notes),
               Containing("mallory: is a symbolic link, and links are never "
                          "followed: ignored"));
}

TEST_CASE("FIFOs, sockets and devices neither hang nor are taken") {
    ClassOnDisk all;
    all.empty("anna/sub");
    REQUIRE(mkfifo(all.at("anna/prev.cpp").c_str(), 0666) == 0);
    REQUIRE(mkfifo(all.at("anna/sub/pipe").c_str(), 0666) == 0);
    if (geteuid() == 0)
        REQUIRE(mknod(all.at("anna/face_sides.cpp").c_str(), S_IFCHR | 0666,
                      makedev(1, 5)) == 0);
    const auto start = std::chrono::steady_clock::now();
    const HandedIn anna = all.only();
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
    CHECK(anna.files.empty());
    CHECK_THAT(joined(anna.notes),
               Containing("prev.cpp: is not a regular file: refused"));
    CHECK_THAT(joined(anna.notes),
               Containing("sub/pipe: is not a regular file: refused"));
}

TEST_CASE("a folder with the name of a file is no file") {
    ClassOnDisk all;
    all.file("anna/prev.cpp/prev.cpp", "inside");
    CHECK(all.only().files.at("prev.cpp") == "inside");
}

TEST_CASE("a file of exactly the limit is taken, one byte more is refused") {
    ClassOnDisk all;
    IngestLimits limits;
    limits.file_bytes = 100;
    all.file("anna/prev.cpp", std::string(100, 'x'))
        .file("anna/face_sides.cpp", std::string(101, 'x'));
    const HandedIn anna = all.only(limits);
    CHECK(anna.files.at("prev.cpp").size() == 100);
    CHECK(anna.files.count("face_sides.cpp") == 0);
    CHECK(joined(anna.notes) ==
          "face_sides.cpp: has 101 bytes; at most 100 are taken: refused\n");
}

TEST_CASE("a sparse file of a terabyte is refused at once") {
    ClassOnDisk all;
    all.file("anna/prev.cpp");
    REQUIRE(truncate(all.at("anna/prev.cpp").c_str(), off_t{1} << 40) == 0);
    CHECK_THAT(joined(all.only().notes), Containing("has 1099511627776 bytes"));
}

TEST_CASE("the bytes of a student are limited in all") {
    ClassOnDisk all;
    IngestLimits limits;
    limits.total_bytes = 150;
    all.file("anna/boundary_walk.cpp", std::string(100, 'x'))
        .file("anna/face_sides.cpp", std::string(100, 'x'))
        .file("anna/prev.cpp", std::string(50, 'x'));
    const HandedIn anna = all.only(limits);
    CHECK(anna.files.size() == 2);
    CHECK_THAT(joined(anna.notes),
               Containing("face_sides.cpp: at most 150 bytes of a student"));
}

TEST_CASE("the files of a class are on disk, and not in memory") {
    constexpr std::size_t four_mib = 4u << 20;
    ClassOnDisk all;
    ArchiveWriter writer(tar_gz);
    for (int k = 0; k < 40; ++k) {
        const std::string file = std::to_string(k) + "/prev.cpp";
        all.file("class/" + file, "");
        std::filesystem::resize_file(all.at("class/" + file), four_mib);
        writer.add_zeros({file, ""}, four_mib);
    }
    all.file("class.tgz", writer.finish());
    CHECK(memory_for(all.at("class")) < 40);
    CHECK(memory_for(all.at("class.tgz")) < 40);
}

TEST_CASE("when the first file of a name is refused the next one is taken") {
    ClassOnDisk all;
    IngestLimits limits;
    limits.file_bytes = 10;
    all.file("anna/prev.cpp", "much too long").file("anna/a/prev.cpp", "good");
    CHECK(all.only(limits).files.at("prev.cpp") == "good");
}

TEST_CASE("a folder with too many files is left out, what lies above stays") {
    ClassOnDisk all;
    all.file("anna/prev.cpp", "mine").file("anna/a/face_sides.cpp", "too");
    for (int k = 0; k < 2000; ++k) all.file("anna/b/" + std::to_string(k), "");
    const HandedIn anna = all.only();
    CHECK(anna.files.size() == 2);
    CHECK_THAT(joined(anna.notes),
               Containing("b/ has more than are left: it and what follows"));
}

TEST_CASE("a flood of refusals gives a few notes") {
    ClassOnDisk all;
    for (int k = 0; k < 500; ++k)
        all.link("anna/" + std::to_string(k), "nowhere");
    const HandedIn anna = all.only();
    REQUIRE(anna.notes.size() == 41);
    CHECK(anna.notes.back() == "and 460 more notes");
}

TEST_CASE("files beside the students' folders are noted") {
    ClassOnDisk all;
    all.file("prev.cpp").file("anna/prev.cpp").file(".DS_Store").empty(".git");
    const ClassHandedIn found = all.find();
    CHECK(found.submissions.size() == 1);
    CHECK(joined(found.notes) ==
          ".DS_Store: ignored; expected a folder for each student\n"
          ".git: ignored; expected a folder for each student\n"
          "prev.cpp: ignored; expected a folder for each student\n");
}

TEST_CASE("names that are anything but names are data") {
    ClassOnDisk all;
    const std::vector<std::string> names = {"-rf",
                                            "=cmd()",
                                            "a\nb",
                                            "Anna",
                                            "anna",
                                            "con",
                                            "dot.",
                                            "e\xCC\x81",
                                            "\xC3\xA9",
                                            "\xff\xfe",
                                            "\xE2\x80\xAEgpj",
                                            std::string(255, 'n'),
                                            " "};
    for (const std::string& name : names) all.file(name + "/prev.cpp", name);
    const ClassHandedIn found = all.find();
    CHECK(found.submissions.size() == names.size());
    std::string before;
    for (const HandedIn& one : found.submissions) {
        CHECK(one.files.at("prev.cpp") == one.student);
        CHECK(one.id.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghij"
                                       "klmnopqrstuvwxyz0123456789._-") ==
              one.id.npos);
        CHECK(before < one.id);
        before = one.id;
    }
}

TEST_CASE("a class that is not there or cannot be read is an error") {
    ClassOnDisk all;
    all.file("anna/prev.cpp");
    CHECK_THROWS_AS(find_submissions(all.at("none"), asked_for), IngestError);
    CHECK_THROWS_AS(find_submissions(all.at("anna/prev.cpp"), asked_for),
                    IngestError);
    try {
        find_submissions(all.at("none"), asked_for);
    } catch (const IngestError& error) {
        CHECK_THAT(error.what(),
                   Containing("none: cannot be read (No such file or "
                              "directory); expected a folder with a folder for "
                              "each student"));
    }
}

TEST_CASE("what may not be read is noted, and the others are read") {
    ClassOnDisk all;
    all.file("anna/prev.cpp").file("bruno/prev.cpp").file("carla/prev.cpp");
    using std::filesystem::perms;
    std::filesystem::permissions(all.at("."), perms(0755));
    std::filesystem::permissions(all.at("anna"), perms(0));
    std::filesystem::permissions(all.at("bruno/prev.cpp"), perms(0));
    const uid_t was = geteuid();
    if (was == 0) REQUIRE(seteuid(65534) == 0);
    const ClassHandedIn found = all.find();
    if (was == 0) REQUIRE(seteuid(was) == 0);
    std::filesystem::permissions(all.at("anna"), perms(0755));
    REQUIRE(found.submissions.size() == 3);
    CHECK(joined(found.submissions[0].notes) ==
          "the folder cannot be read (Permission denied)\n");
    CHECK(joined(found.submissions[1].notes) ==
          "prev.cpp: cannot be read (Permission denied): refused\n");
    CHECK(found.submissions[2].files.size() == 1);
}
