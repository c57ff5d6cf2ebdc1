#include "exercises/07_files/read_obj.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

/// What the std::runtime_error says that reading the text ends in.
std::string complaint(const std::string& text) {
    try {
        read_obj(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no std::runtime_error";
}

const std::string corner =
    "# cube corner\nmtllib wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
    "vt 0.5 0.5\ng bottom\nf 1/1/1 3/1/1 2/1/1\nv 0 0 1 0.5 0.5 0.5\n"
    "g sides\n";

}  // namespace

TEST_CASE("the cube of the lecture is read", "[points:1]") {
    hint("Which is the first vertex in the file, and which in the mesh?");
    const IndexedMesh mesh = read_obj(
        "v 0.0 0.0 0.0\nv 0.0 0.0 1.0\nv 0.0 1.0 0.0\nv 0.0 1.0 1.0\n"
        "v 1.0 0.0 0.0\nv 1.0 0.0 1.0\nv 1.0 1.0 0.0\nv 1.0 1.0 1.0\n"
        "f 1 3 7 5\nf 1 2 4 3\nf 3 4 8 7\nf 5 7 8 6\nf 1 5 6 2\nf 2 6 8 4\n");
    REQUIRE(mesh.positions.size() == 8);
    CHECK(mesh.positions[1] == Vec3{0, 0, 1});
    CHECK(mesh.positions[6] == Vec3{1, 1, 0});
    CHECK(mesh.faces == FaceList{{0, 2, 6, 4},
                                 {0, 1, 3, 2},
                                 {2, 3, 7, 6},
                                 {4, 6, 7, 5},
                                 {0, 4, 5, 1},
                                 {1, 5, 7, 3}});
    CHECK(mesh.loose_edges.empty());
}

TEST_CASE("slashes, groups, numbers from the end, and lines", "[points:1]") {
    hint("What does the first word of each line say about the rest of it?");
    const IndexedMesh mesh =
        read_obj(corner + "f 1 2 -1\nf 1//7 4//7 3//7\nl 2 3 4\n");
    CHECK(mesh.positions ==
          std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh.faces == FaceList{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}});
    CHECK(mesh.loose_edges == std::vector<std::array<int, 2>>{{1, 2}, {2, 3}});
}

TEST_CASE("what is wrong is refused, with its line", "[points:1]") {
    hint("Do you count every line, and look at every word of v, f and l?");
    using Catch::Matchers::StartsWith;
    for (const char* const wrong :
         {"f 1 2 5", "f 1 2 -5", "f 1 2 0", "f 1 2", "face 1 2 4", "v 0 abc 0"})
        CHECK_THAT(complaint(corner + wrong + "\nf 1 2 3\n"),
                   StartsWith("line 11: "));
}
