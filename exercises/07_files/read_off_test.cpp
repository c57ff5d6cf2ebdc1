#include "exercises/07_files/read_off.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

/// What the std::runtime_error says that reading the text ends in.
std::string complaint(const std::string& text) {
    try {
        read_off(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no std::runtime_error";
}

}  // namespace

TEST_CASE("the tetrahedron of the lecture is read", "[points:1]") {
    hint("Which three kinds of lines come after the word OFF, in which order?");
    const IndexedMesh mesh = read_off(
        "OFF\n4 4 0\n-1 -1 -1\n1 1 -1\n1 -1 1\n-1 1 1\n"
        "3 1 2 3\n3 1 0 2\n3 3 2 0\n3 0 1 3\n");
    CHECK(mesh.positions ==
          std::vector<Vec3>{{-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}});
    CHECK(mesh.faces == FaceList{{1, 2, 3}, {1, 0, 2}, {3, 2, 0}, {0, 1, 3}});
}

TEST_CASE("comments, blank lines and colours do not matter", "[points:1]") {
    hint("What is left of a line without its comment, and what if nothing is?");
    const IndexedMesh mesh = read_off(
        "# by hand\nOFF\n\n4 2 0  # counts\n0 0 0\n1 0 0\n  \t \n1 1.5 0\n"
        "0 1 -2e3 # far\n\n# faces\n3 0 1 2 255 0 0\n3 0 2 3");
    CHECK(mesh.positions ==
          std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1.5, 0}, {0, 1, -2000}});
    CHECK(mesh.faces == FaceList{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("what is wrong is refused, with its line", "[points:1]") {
    hint("Do you count every line, also those that do not matter?");
    using Catch::Matchers::StartsWith;
    const std::string begin = "OFF\n# three\n3 1 0\n0 0 0\n1 0 0\n";
    CHECK_THAT(complaint(begin + "0 1 0\n\n3 0 1 3\n"), StartsWith("line 8: "));
    CHECK_THAT(complaint(begin + "0 1\n3 0 1 2\n"), StartsWith("line 6: "));
    CHECK_THAT(complaint(begin + "0 1 0\n3 0 1 2\n3 2 1 0\n"),
               StartsWith("line 8: "));
}
