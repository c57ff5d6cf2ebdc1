// Hidden suite of read_off.
#include "exercises/07_files/read_off.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/07_files/mesh_text.h"

using namespace course;

namespace {

/// How what is read from the text differs from the mesh, or "".
std::string misread(const std::string& text, const IndexedMesh& wanted) {
    return hidden::mesh_difference(read_off(text), wanted);
}

/// The line that the error names; 0 when there is none, -1 when it names none.
int refused_at(const std::string& text) {
    try {
        read_off(text);
    } catch (const std::runtime_error& error) {
        return hidden::named_line(error.what());
    }
    return 0;
}

std::vector<Fixture> meshes() {
    return hidden::without_loose_edges(hidden::file_meshes());
}

/// Three vertices and a face, one line for each.
IndexedMesh one_triangle() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
}

std::string with_counts(const std::string& counts) {
    return "OFF\n" + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

/// The second vertex is on line 4.
std::string with_vertex(const std::string& vertex) {
    return "OFF\n3 1 0\n0 0 0\n" + vertex + "\n0 1 0\n3 0 1 2\n";
}

/// Four vertices and two faces, the first of them on line 7.
std::string with_face(const std::string& face) {
    return "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + face + "\n3 0 2 3\n";
}

}  // namespace

TEST_CASE("meshes of all kinds are read", "[points:2]") {
    hint("Are order, corners and coordinates those of the text, to the last?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : meshes()) {
        const OnMesh on(fixture);
        const IndexedMesh awkward =
            hidden::with_awkward_positions(fixture.mesh, ++salt);
        for (const IndexedMesh& mesh : {fixture.mesh, awkward})
            CHECK(misread(hidden::joined(hidden::off_lines(mesh)), mesh) == "");
    }
}

TEST_CASE("comments, blanks and line ends do not matter", "[points:2]") {
    hint("May `#` stand behind a number? What else is blank beside a space?");
    std::uint64_t salt = 100;
    for (const Fixture& fixture : meshes()) {
        const OnMesh on(fixture);
        const auto file =
            hidden::decorated(hidden::off_lines(fixture.mesh), ++salt);
        CHECK(misread(file.text, fixture.mesh) == "");
    }
}

TEST_CASE("lines of Windows, and a last line without an end", "[points:1]") {
    hint(
        "What is left at the end of a line when \\n is taken off, but not "
        "\\r?");
    const IndexedMesh mesh = one_triangle();
    const hidden::TextLines lines = hidden::off_lines(mesh);
    CHECK(misread(hidden::joined(lines, "\r\n"), mesh) == "");
    CHECK(misread(hidden::joined(lines, "\r\n\r\n"), mesh) == "");
    std::string text = hidden::joined(lines);
    text.pop_back();
    CHECK(misread(text, mesh) == "");
    CHECK(misread(text + "\r\n \t \r\n\r\n#", mesh) == "");
    CHECK(misread("\n#OFF\n" + text + " ", mesh) == "");
}

TEST_CASE("counts behind OFF, and a third count of any size", "[points:1]") {
    hint("Must the counts stand on the line after OFF? Is the third checked?");
    const IndexedMesh mesh = one_triangle();
    const std::string rest = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    CHECK(misread("OFF 3 1 0" + rest, mesh) == "");
    CHECK(misread("# first\n OFF\t3 1 3 # all" + rest, mesh) == "");
    CHECK(misread("OFF 3 1 7\r\n\r\n" + rest, mesh) == "");
    for (const char* const edges : {"0", "3", "1", "2000000000"})
        CHECK(misread(with_counts("3 1 " + std::string(edges)), mesh) == "");
}

TEST_CASE("empty meshes, vertices without a face, corners met twice",
          "[points:1]") {
    hint("Is it the reader's business which vertices the faces use?");
    CHECK(misread("OFF\n0 0 0\n", {}) == "");
    CHECK(misread("OFF 0 0 0", {}) == "");
    CHECK(misread("OFF\n2 0 0\n1 2 3\n4 5 6\n",
                  {{{1, 2, 3}, {4, 5, 6}}, {}, {}}) == "");
    IndexedMesh mesh = one_triangle();
    mesh.positions.push_back({5, 5, 5});
    CHECK(misread("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n", mesh) ==
          "");
    mesh.faces = {{1, 3, 1, 2}, {2, 2, 2}, {1, 3, 1, 2}};
    CHECK(misread(hidden::joined(hidden::off_lines(mesh)), mesh) == "");
}

TEST_CASE("numbers as programs write them", "[points:1]") {
    hint("Do you read a number yourself, or does a function that knows them?");
    const auto position = [](const std::string& vertex) {
        const IndexedMesh mesh = read_off(with_vertex(vertex));
        REQUIRE(mesh.vertex_count() == 3);
        return mesh.positions[1];
    };
    CHECK(position("1 -2 0") == Vec3{1, -2, 0});
    CHECK(position(".5 -.25 5.") == Vec3{0.5, -0.25, 5});
    CHECK(position("1e3 1E-2 -2.5e+1") == Vec3{1000, 0.01, -25});
    CHECK(position("007 0.1000 0e9") == Vec3{7, 0.1, 0});
    CHECK(position("0.3 0.30000000000000004 1e300") ==
          Vec3{0.3, 0.1 + 0.2, 1e300});
    CHECK(position("123456789012345678 1e-300 0.1234567890123456789") ==
          Vec3{123456789012345678.0, 1e-300, 0.1234567890123456789});
}

TEST_CASE("the colour of a face is not a corner", "[points:1]") {
    hint("How many of the numbers on a face's line are its corners?");
    const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                           {{1, 2, 3}, {0, 2, 3}},
                           {}};
    for (const char* const colour :
         {" 0", " 255 0 0", " 0 1 2", " 0.5 0.25 1", " 1 2 3 4", " 7 9",
          " 1e-1 .5 1 1", "\t3 3 0 # 3", " 0 0 0#"})
        CHECK(misread(with_face("3 1 2 3" + std::string(colour)), mesh) == "");
}

TEST_CASE("a text that does not begin as it must", "[points:1]") {
    hint("What must the first word be, and how many counts follow it?");
    for (const char* const word :
         {"off", "COFF", "OFFX", "0FF", "3 1 0", "ply", "OF F", "\"OFF\""})
        CHECK(refused_at("\n" + std::string(word) + "\n3 1 0\n") == 2);
    for (const char* const counts :
         {"3 1", "3", "3 1 0 0", "-3 1 0", "3 -1 0", "3 1 -1", "3.0 1 0",
          "3 1x 0", "3 1 none", "three 1 0", "3, 1, 0", "3 1e0 0"})
        CHECK(refused_at(with_counts(counts)) == 2);
    CHECK(refused_at("#\nOFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") == 2);
    CHECK(refused_at("OFF 3 1 0 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") == 1);
    CHECK(refused_at("OFF OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") == 1);
    CHECK(refused_at("OFF -3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") == 1);
}

TEST_CASE("vertices that are none", "[points:2]") {
    hint("Was the whole word a number, and were there exactly three of them?");
    for (const char* const vertex :
         {"1 0", "1", "1 0 0 0", "1 0 0 1 1 1", "a 0 0", "0 b 0", "0 0 c",
          "1.5x 0 0", "0 1-2 0", "0 0 1.2.3", "1,5 0 0", "1, 0, 0", "0 0 -",
          "0 1e 0", "e5 0 0", ". 0 0", "0 0 1;", "1 0 #0"})
        CHECK(refused_at(with_vertex(vertex)) == 4);
}

TEST_CASE("coordinates that are not finite", "[points:1]") {
    hint("Is everything that the library takes for a number one on a map?");
    for (const char* const word : {"nan", "inf", "-inf", "NaN", "infinity",
                                   "-nan", "1e999", "-1e400", "1e309"})
        for (const char* const rest : {" 0 0", " 1 nan"})
            CHECK(refused_at(with_vertex(std::string(word) + rest)) == 4);
    CHECK(refused_at(with_vertex("0 0 1e999")) == 4);
    CHECK(refused_at(with_vertex("0 inf 0")) == 4);
}

TEST_CASE("faces that are none", "[points:2]") {
    hint("What must hold of the number of corners, and of each corner?");
    for (const char* const face :
         {"2 0 1", "1 0", "0", "-3 0 1 2", "4 0 1 2", "3 0 1", "3", "5 0 1 2 3",
          "300 0 1 2", "3.0 0 1 2", "x 0 1 2", "3x 0 1 2", "0 1 2",
          "2000000000 0 1 2"})
        CHECK(refused_at(with_face(face)) == 7);
    for (const char* const corners :
         {"0 1 4", "4 1 2", "0 5 2", "-1 0 1", "0 1 -1", "0 1 -4", "0 1 400",
          "0 1.5 2", "0 1 2x", "0 a 2", "0 1 2.0", "0 1 1e0", "0, 1, 2",
          "0 1 #2", "0/1 1 2", "4 4 4"})
        CHECK(refused_at(with_face("3 " + std::string(corners))) == 7);
    CHECK(refused_at("OFF\n0 1 0\n3 0 1 2\n") == 3);
    CHECK(refused_at("OFF\n0 1 0\n3 0 0 0\n") == 3);
}

TEST_CASE("something after the last face", "[points:1]") {
    hint("After the last face, what may still come?");
    const std::string text = with_counts("3 1 0");
    CHECK(refused_at(text + "3 0 1 2\n") == 7);
    CHECK(refused_at(text + "\r\n# end\n x") == 9);
    CHECK(refused_at(text + "\n0 0 0\n0 0 0\n") == 8);
    CHECK(refused_at(text + "#\n0\n") == 8);
    CHECK(refused_at("OFF\n1 0 0\n0 0 0\n3 0 0 0\n") == 4);
    CHECK(refused_at("OFF\n0 0 0\n\n0 0 0\n") == 4);
}

TEST_CASE("a text that ends too early, at any line", "[points:2]") {
    hint("Does every line that must come do so? Who finds out, and where?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::tetra(), zoo::lens(), zoo::triangle()}) {
        const OnMesh on(fixture);
        hidden::TextLines lines = hidden::off_lines(fixture.mesh);
        while (!lines.empty()) {
            lines.pop_back();
            const int last = static_cast<int>(lines.size());
            const int line = refused_at(hidden::joined(lines));
            CHECK((last <= line && line <= last + 1));
            const int padded = refused_at(hidden::joined(lines) + "\n#\n \n");
            CHECK((last <= padded && padded <= last + 4));
        }
    }
}

TEST_CASE("counts that are too small or too large", "[points:1]") {
    hint("What is the first line that cannot be what the counts say it is?");
    CHECK(refused_at(with_counts("2 1 0")) == 5);
    CHECK(refused_at(with_counts("4 1 0")) == 6);
    CHECK(refused_at(with_counts("3 0 0")) == 6);
    CHECK(refused_at(with_counts("0 1 0")) == 3);
    CHECK(refused_at(with_counts("1 3 0")) == 4);
    const int line = refused_at(with_counts("3 2 0"));
    CHECK((line == 6 || line == 7));
}

TEST_CASE("of several defects, the line of the first", "[points:1]") {
    hint("Do you look at some kinds of defects earlier than at others?");
    CHECK(refused_at("OFF\n3 2 0\n0 0 0\n0 x 0\n0 1\n3 0 1 9\n2 0 1\n7\n") ==
          4);
    CHECK(refused_at("OFF\n3 2 0\n0 0 0\n0 0 0\n0 1 1\n3 0 1 9\n2 0 1\n7\n") ==
          6);
    CHECK(refused_at("OFF\n3 2 0\n0 0 0\n0 0 0\n0 1 1\n2 0 1\n3 0 1 9\n") == 6);
    CHECK(refused_at("OFF\n3 9 0\n0 0 0\n0 0 0\n0 1 nan\n2 0 1\n") == 5);
    CHECK(refused_at("OFF\n3 9 0\n0 0 0\n0 0 0\n0 1 0\n3 0 1 3\n") == 6);
    CHECK(refused_at("off\n3 1\n") == 1);
}

TEST_CASE("the line of a defect among comments and blank lines", "[points:2]") {
    hint("Which lines count, those with something on them or all?");
    std::uint64_t salt = 200;
    for (const Fixture& fixture : {zoo::slide(), zoo::cube(), zoo::torus7()}) {
        const OnMesh on(fixture);
        const hidden::TextLines lines = hidden::off_lines(fixture.mesh);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            hidden::TextLines damaged = lines;
            damaged[k].back() = 'x';
            const auto file = hidden::decorated(damaged, ++salt);
            CHECK(refused_at(file.text) == file.number[k]);
        }
    }
}

TEST_CASE("counts that promise more than there is", "[points:1]") {
    hint("When do you make room for a vertex: when promised, or when read?");
    const std::string text = "OFF\n2000000000 1 0\n0 0 0\n1 0 0\n";
    const int line = refused_at(text);
    CHECK((line == 4 || line == 5));
    const int faces = refused_at(with_counts("3 2000000000 0"));
    CHECK((faces == 6 || faces == 7));
    CHECK(refused_at(with_counts("3 1 2000000000") + "x") == 7);
    CHECK(refused_at(with_face("2000000000 0 1 2")) == 7);
}

TEST_CASE("a large file", "[points:1][once]") {
    hint("How often is the whole text copied while you read it?");
    const IndexedMesh mesh =
        hidden::with_awkward_positions(grid(120, 120, Cells::triangles), 300);
    CHECK(misread(hidden::joined(hidden::off_lines(mesh)), mesh) == "");
}
