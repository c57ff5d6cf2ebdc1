// What JPlag and Dolos are given: each student's files, and no name that was to
// be replaced.
#include "grader/tests/class_on_disk.h"
#include "grader/tests/grader_program.h"

using namespace grader;
using namespace grader::tests;

namespace fs = std::filesystem;

namespace {

/// Three students, one of them with a name that wants to be a formula.
class Exported {
public:
    explicit Exported(std::vector<std::string> more = {}) {
        files_.file("class/anna rossi/face_sides.cpp", "int anna;")
            .file("class/anna rossi/week/complete_table.csv", "0,1")
            .file("class/=cmd()/face_sides.cpp", "int cmd;")
            .file("class/=cmd()/tip.cpp", "int tip;")
            .file("class/carla/notes.txt", "none")
            .file("a.toml",
                  "name = \"x\"\n[exercises]\nface_sides = 1\n"
                  "complete_table = 1\ntip = 1\n");
        std::vector<std::string> words = {
            "plagiarism",   files_.at("class").string(),
            "--assignment", files_.at("a.toml").string(),
            "--out",        out().string()};
        words.insert(words.end(), more.begin(), more.end());
        said = grader_says(words);
        INFO(said.text);
        CHECK(said.code == 0);
    }
    fs::path out() const { return files_.at("out"); }
    std::string text(const std::string& file) const {
        return file_contents(out() / file);
    }
    /// Paths and bytes of all files, but for the instructor's own list.
    std::string everything() const {
        std::string all;
        for (const auto& one : fs::recursive_directory_iterator(out()))
            all += one.path().lexically_relative(out()).string() + "\n" +
                   (one.is_regular_file() ? file_contents(one.path()) : "");
        return all;
    }

    Said said;

private:
    ClassOnDisk files_;
};

std::size_t folders_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("each student has a folder, and skeletons are the base code") {
    const Exported all;
    // Who handed in nothing has none.
    CHECK(folders_in(all.out() / "submissions") == 2);
    CHECK_THAT(all.everything(), Containing("int anna;"));
    CHECK_THAT(all.everything(), Containing("int cmd;"));
    CHECK_THAT(all.text("base/face_sides.cpp"), Containing("TODO(student)"));
    CHECK(fs::exists(all.out() / "base/complete_table.csv"));
    CHECK_FALSE(fs::exists(all.out() / "info_complete_table.csv"));
}

TEST_CASE("Dolos gets the path and the name of each file, as data") {
    const Exported all;
    const std::string info = all.text("info_face_sides.csv");
    CHECK(info.starts_with("filename,full_name\n"));
    CHECK(std::count(info.begin(), info.end(), '\n') == 3);
    CHECK_THAT(info, Containing(",anna rossi\n"));
    CHECK_THAT(info, Containing(",\"'=cmd()\"\n"));
    for (const auto& one : fs::directory_iterator(all.out() / "submissions"))
        CHECK_THAT(info,
                   Containing("submissions/" + one.path().filename().string() +
                              "/face_sides.cpp,"));
}

TEST_CASE("without names nothing tells who it is but the list beside it") {
    const Exported all({"--anonymous"});
    const std::string everything = all.everything();
    CHECK_THAT(everything, !Containing("rossi"));
    CHECK_THAT(everything, !Containing("=cmd"));
    CHECK_THAT(everything, Containing("student_00"));
    const std::string names = file_contents(all.out().string() + ".names.csv");
    CHECK_THAT(names, Containing(",anna rossi\n"));
    CHECK(std::count(names.begin(), names.end(), '\n') == 1 + 3);
}

TEST_CASE("the command lines of both programs are printed") {
    const Exported all;
    CHECK_THAT(all.said.text, Containing("-l cpp -bc base submissions"));
    CHECK_THAT(all.said.text,
               Containing("dolos run -f web -l cpp -i base/face_sides.cpp "
                          "info_face_sides.csv"));
    // One file is like no other, and an error for Dolos.
    CHECK_THAT(all.said.text, !Containing("info_tip.csv"));
}

TEST_CASE("a folder with something in it is left alone") {
    const Exported all;
    const std::string before = all.everything();
    const Said again = grader_says(
        {"plagiarism", all.out().string(), "--assignment",
         (all.out() / "../a.toml").string(), "--out", all.out().string()});
    CHECK(again.code == 2);
    CHECK_THAT(again.text, Containing("is not empty"));
    CHECK(all.everything() == before);
}
