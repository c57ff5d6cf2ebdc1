// What both readers must take: lines longer than any buffer, blanks of all
// kinds, line ends of all kinds, and any locale of the machine.
#include <clocale>
#include <string>

#include "course/mesh/mesh_file.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_files.h"

using namespace course;

namespace {

/// The tetrahedron of the zoo with an offset, line by line.
using TextLines = std::vector<std::string>;

const TextLines obj_lines = {"v 0.5 0 0", "v 1e3 0 0", "v 0 -.25 0",
                             "v 0 0 1",   "f 1 2 3",   "f 1 2 4"};
const TextLines off_lines = {"OFF",      "4 2 0", "0.5 0 0", "1e3 0 0",
                             "0 -.25 0", "0 0 1", "3 0 1 2", "3 0 1 3"};

const IndexedMesh expected{
    {{0.5, 0, 0}, {1000, 0, 0}, {0, -0.25, 0}, {0, 0, 1}},
    {{0, 1, 2}, {0, 1, 3}},
    {}};

std::string joined(const TextLines& lines, const std::string& end) {
    std::string text;
    for (const std::string& line : lines) text += line + end;
    return text;
}

/// Each line with every blank made `blanks`, and something before and after.
TextLines padded(const TextLines& lines, const std::string& before,
                 const std::string& blanks, const std::string& after) {
    TextLines all;
    for (const std::string& line : lines) {
        std::string text = before;
        for (const char c : line) text += c == ' ' ? blanks : std::string(1, c);
        all.push_back(text + after);
    }
    return all;
}

/// Whether the mesh is read from the lines, as either kind of file.
void check_read(const std::string& before, const std::string& blanks,
                const std::string& after, const std::string& end) {
    const TemporaryFolder folder;
    for (const bool is_obj : {true, false}) {
        INFO((is_obj ? "OBJ" : "OFF"));
        std::string text = joined(
            padded(is_obj ? obj_lines : off_lines, before, blanks, after), end);
        const auto file = folder / (is_obj ? "mesh.obj" : "mesh.off");
        std::ofstream(file, std::ios::binary) << text;
        CHECK(read_mesh(file) == expected);
        // Without the last line end, or its last character.
        text.pop_back();
        std::ofstream(file, std::ios::binary) << text;
        CHECK(read_mesh(file) == expected);
    }
}

/// Sets the locale of the C library, and back at the end.
class CLocale {
public:
    explicit CLocale(const char* name)
        : saved_(std::setlocale(LC_ALL, nullptr)),
          is_there_(std::setlocale(LC_ALL, name) != nullptr) {}
    CLocale(const CLocale&) = delete;
    CLocale& operator=(const CLocale&) = delete;
    ~CLocale() { std::setlocale(LC_ALL, saved_.c_str()); }
    bool is_there() const { return is_there_; }

private:
    std::string saved_;
    bool is_there_;
};

}  // namespace

TEST_CASE("either reader takes every kind of line end, and none at the end") {
    for (const std::string end : {"\n", "\r\n", "\r", "\n\n", "\r\n\r\n"})
        check_read("", " ", "", end);
}

TEST_CASE("either reader takes tabs, blanks and comments") {
    check_read("", "\t", "", "\n");
    check_read(" \t ", " \t\t ", "\t ", "\r\n");
    check_read("", " ", "# f 9 9 9", "\n");
    check_read("", " ", " #\t#\xC3\xA4", "\r\n");
}

TEST_CASE("either reader takes lines longer than any buffer") {
    const std::string million(1'000'000, ' ');
    check_read(million, " ", "", "\n");
    check_read("", std::string(300'000, ' '), "", "\r\n");
    check_read("", " ", million, "\n");
    check_read("", " ", "#" + std::string(1'000'000, 'x'), "\n");
}

TEST_CASE("a number of a million digits is the nearest double") {
    const std::string zeros(1'000'000, '0');
    const TemporaryFolder folder;
    const auto file = folder / "mesh.obj";
    std::ofstream(file) << "v 0.5" << zeros << " " << zeros << "2 0." << zeros
                        << "1\n";
    CHECK(message_of([&] { read_mesh(file); }) ==
          file.string() +
              ":1: v: `0.0000000000000000000000...` is too large "
              "or too small for a number");
    std::ofstream(file) << "v 0.5" << zeros << " " << zeros << "2 -.1" << zeros
                        << "\n";
    CHECK(read_mesh(file).positions == std::vector<Vec3>{{0.5, 2, -0.1}});
}

TEST_CASE("a locale with a decimal comma does not matter to reader or writer") {
    const TemporaryFolder folder;
    bool is_any = false;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "it_IT.UTF-8",
                             "it_IT.utf8", "fr_FR.UTF-8"}) {
        const CLocale locale(name);
        if (!locale.is_there()) continue;
        is_any = true;
        for (const char* file : {"mesh.obj", "mesh.off"}) {
            write_mesh(folder / file, expected);
            CHECK(contains(content(folder / file), "0.5 0 0\n"));
            CHECK(read_mesh(folder / file) == expected);
        }
    }
    if (!is_any) WARN("no locale with a decimal comma is installed here");
}
