// OFF files: what is read, and what is said of bad ones.
#include "course/mesh/off.h"

#include <cmath>
#include <stdexcept>

#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_files.h"

namespace {

using namespace course;

/// Up to and with the vertices: lines 1 to 6.
const std::string square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

IndexedMesh read(std::string_view text) {
    const TemporaryFolder folder;
    return read_off(file_of(folder, text));
}

std::vector<std::string> defects(std::string_view text) {
    std::vector<std::string> lines;
    for (const auto& [line, what] : defects_of(read_off, text))
        lines.push_back(std::to_string(line) + ": " + what);
    return lines;
}

using Texts = std::vector<std::string>;

IndexedMesh round_trip(const IndexedMesh& mesh) {
    const TemporaryFolder folder;
    write_off(folder / "mesh.off", mesh);
    return read_off(folder / "mesh.off");
}

}  // namespace

TEST_CASE("the lecture's OFF example is the tetrahedron of the zoo") {
    CHECK(read("OFF\n4 4 0\n-1 -1 -1\n1 1 -1\n1 -1 1\n-1 1 1\n"
               "3 1 2 3\n3 1 0 2\n3 3 2 0\n3 0 1 3\n") == zoo::tetra().mesh);
}

TEST_CASE("an OFF file gives faces of any degree and isolated vertices") {
    const IndexedMesh mesh = read(square + "4 0 1 2 3\n3 0 2 1\n");
    CHECK(mesh.faces == FaceList{{0, 1, 2, 3}, {0, 2, 1}});
    CHECK(mesh.positions[2] == Vec3{1, 1, 0});
    CHECK(read("OFF\n2 0 0\n1 2 3\n4 5 6\n").vertex_count() == 2);
    CHECK(read("OFF 0 0 0") == IndexedMesh{});
    std::string many = "OFF\n300 1 0\n";
    for (int v = 0; v < 300; ++v) many += std::to_string(v) + " 0 0\n";
    many += "300";
    for (int v = 0; v < 300; ++v) many += " " + std::to_string(v);
    CHECK(read(many).faces[0].size() == 300);
}

TEST_CASE("comments, blank lines and line ends of an OFF file do not matter") {
    const IndexedMesh expected = read(square + "3 0 1 2\n3 0 2 3\n");
    const auto same = [&](const std::string& text) {
        CHECK(read(text) == expected);
    };
    same("# head\n\n" + square + "# faces\n3 0 1 2 # one\n\n3 0 2 3\n\n#\n \t");
    same(square + "\t3 0 1\t2 \n  3  0 2 3");
    same("OFF 4 2 5\n" + square.substr(10) + "3 0 1 2\n3 0 2 3\n");
    same("\xEF\xBB\xBF" + square + "3 0 1 2\n3 0 2 3\n");
    std::string crlf;
    for (const char c : square + "3 0 1 2\n3 0 2 3\n")
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    same(crlf);
}

TEST_CASE("a colour after a face is passed over") {
    CHECK(read(square + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n").faces ==
          FaceList{{0, 1, 2}, {0, 2, 3}});
    CHECK(read(square + "3 0 1 2 7\n3 0 2 3\n").faces.size() == 2);
    CHECK(defects(square + "3 0 1 2 red\n3 0 2 3 1 2 3 4 5\n") ==
          Texts{"7: face 0: colour: `red` is not a number",
                "8: face 1: 5 numbers after the corners, but a colour has at "
                "most 4"});
}

TEST_CASE("a wrong head of an OFF file is reported") {
    CHECK(defects("") == Texts{"0: the file is empty, expected OFF"});
    CHECK(defects("# x\n") == Texts{"1: the file is empty, expected OFF"});
    CHECK(defects("4 4 0\n") ==
          Texts{"1: the first word is `4`, expected OFF"});
    CHECK(defects("\nCOFF\n4 4 0\n") ==
          Texts{"2: the first word is `COFF`, expected OFF"});
    CHECK(defects("OFF\n\n") ==
          Texts{"2: the file ends after OFF, expected 3 counts"});
    CHECK(defects("OFF\n4 4\n") ==
          Texts{"2: 2 counts, expected 3: of vertices, faces and edges"});
    CHECK(defects("OFF 1\n") ==
          Texts{"1: 1 count, expected 3: of vertices, faces and edges"});
    CHECK(defects("OFF\n4 x 0\n") ==
          Texts{"2: counts: `x` is not a whole number"});
    CHECK(defects("OFF\n4 -1 0\n") == Texts{"2: counts: `-1` is negative"});
    CHECK(defects("OFF\n4 99999999999 0\n") ==
          Texts{"2: counts: `99999999999` is too large for a whole number"});
    CHECK(defects("OFF BINARY\n4 4 0\n") ==
          Texts{"1: 1 count, expected 3: of vertices, faces and edges"});
}

TEST_CASE("counts that are too large are reported, without taking memory") {
    CHECK(defects("OFF\n2000000000 2000000000 0\n0 0 0\n") ==
          Texts{"3: the file ends after 1 of 2000000000 vertices",
                "3: the file ends after 0 of 2000000000 faces"});
    CHECK(defects(square + "3 0 1 2\n\n") ==
          Texts{"8: the file ends after 1 of 2 faces"});
    CHECK(defects("OFF\n5 2 0\n" + square.substr(10) + "3 0 1 2\n3 0 2 3\n") ==
          Texts{"7: vertex 4 has 4 numbers, expected x y z",
                "8: the file ends after 1 of 2 faces"});
}

TEST_CASE("anything after the last face is reported with its line") {
    CHECK(defects(square + "3 0 1 2\n3 0 2 3\n\n3 0 1 3\nend\n") ==
          Texts{"10: `3 0 1 3` after the last of 2 faces, expected the end of "
                "the file",
                "11: `end` after the last of 2 faces, expected the end of the "
                "file"});
    CHECK(defects("OFF\n0 0 0\n1 2 3\n").size() == 1);
}

TEST_CASE("bad coordinates of an OFF file are reported") {
    CHECK(defects("OFF\n6 0 0\n0 abc 0\n0 0 nan\n1 2\n1 2 3 4\ninf 0 1x\n"
                  "1e999 0 0\n") ==
          Texts{"3: vertex 0: `abc` is not a number",
                "4: vertex 1: `nan` is not a finite number",
                "5: vertex 2 has 2 numbers, expected x y z",
                "6: vertex 3 has 4 numbers, expected x y z",
                "7: vertex 4: `inf` is not a finite number",
                "7: vertex 4: `1x` is not a number",
                "8: vertex 5: `1e999` is too large or too small for a "
                "number"});
}

TEST_CASE("bad faces of an OFF file are reported, all of them") {
    const std::string head = "OFF\n4 9 0\n" + square.substr(10);
    CHECK(defects(head + "2 0 1\n1 0\n0\n-3 0 1 2\nx 0 1 2\n3 0 1\n"
                         "3 0 1 4\n3 -1 b 2\n3.0 0 1 2\n") ==
          Texts{"7: face 0: the number of corners is 2, expected at least 3",
                "8: face 1: the number of corners is 1, expected at least 3",
                "9: face 2: the number of corners is 0, expected at least 3",
                "10: face 3: the number of corners is -3, expected at least 3",
                "11: face 4: `x` is not a whole number",
                "12: face 5: 3 corners, but 2 indices",
                "13: face 6: names vertex 4, but there are 4, from 0",
                "14: face 7: names vertex -1, but there are 4, from 0",
                "14: face 7: `b` is not a whole number",
                "15: face 8: `3.0` is not a whole number"});
}

TEST_CASE("a missing OFF file is reported by name") {
    const TemporaryFolder folder;
    const std::string message =
        message_of([&] { read_off(folder / "missing.off"); });
    CHECK(contains(message, "missing.off: cannot be read: "));
    CHECK_THROWS_AS(read_off(folder.path()), MeshFileError);
}

TEST_CASE("an OFF file is written with counts, and survives a round trip") {
    const TemporaryFolder folder;
    write_off(folder / "mesh.off", zoo::lens().mesh);
    CHECK(content(folder / "mesh.off") ==
          "OFF\n5 2 0\n0 -2 0\n1.5 0 0\n0 2 0\n0 0 0\n-1.5 0 0\n"
          "4 0 1 2 3\n4 0 3 2 4\n");
    for (const Fixture& fixture : zoo::with_table()) {
        CAPTURE(fixture.name);
        if (fixture.mesh.loose_edges.empty())
            CHECK(round_trip(fixture.mesh) == fixture.mesh);
    }
    for (const IndexedMesh& mesh :
         {icosphere(3), torus(9, 7), random_polygons(5), IndexedMesh{}})
        CHECK(round_trip(mesh) == mesh);
}

TEST_CASE("a mesh that OFF cannot hold is refused, and no file appears") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(
        write_off(folder / "mesh.off", zoo::dangling().mesh),
        "the mesh has 1 loose edges, for which OFF has no form; OBJ has");
    IndexedMesh mesh = zoo::lens().mesh;
    mesh.positions[0].x = std::nan("");
    CHECK_THROWS_AS(write_off(folder / "mesh.off", mesh),
                    std::invalid_argument);
    CHECK(std::filesystem::is_empty(folder.path()));
}
