// Hidden suite of read_obj.
#include "exercises/07_files/read_obj.h"

#include <random>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/07_files/mesh_text.h"

using namespace course;

namespace {

/// How what is read from the text differs from the mesh, or "".
std::string misread(const std::string& text, const IndexedMesh& wanted) {
    return hidden::mesh_difference(read_obj(text), wanted);
}

/// The line that the error names; 0 when there is none, -1 when it names none.
int refused_at(const std::string& text) {
    try {
        read_obj(text);
    } catch (const std::runtime_error& error) {
        return hidden::named_line(error.what());
    }
    return 0;
}

const std::string four = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::vector<Vec3> four_positions{
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// Four vertices, and the statement on line 5.
std::string after_four(const std::string& statement) {
    return four + statement + "\nf 1 2 3\n";
}

IndexedMesh with_faces(FaceList faces) {
    return {four_positions, std::move(faces), {}};
}

using Random = std::mt19937_64;

/// A corner of an f or l line, written in one of the ways that it may be.
std::string corner(Random& random, int v, int so_far) {
    const bool backwards = v < so_far && random() % 2 == 0;
    const std::string index = std::to_string(backwards ? v - so_far : v + 1);
    const int way = static_cast<int>(random() % 5);
    if (way == 1) return index + "/" + std::to_string(1 + random() % 9);
    if (way == 2) return index + "//-" + std::to_string(1 + random() % 9);
    if (way == 3) return index + "/2/" + std::to_string(1 + random() % 9);
    return index;
}

/// The mesh with its vertices and faces mixed, in groups, in every way of
/// writing. The order among vertices, among faces and among edges is kept.
hidden::TextLines mixed_lines(const IndexedMesh& mesh, Random& random) {
    const hidden::TextLines plain = hidden::obj_lines(mesh);
    const hidden::TextLines others{
        "g part 1",       "o name",   "s off",      "usemtl f 1 2 3",
        "vt 0.5 nothing", "vn 0 0 1", "mtllib a b", "p 1",
        "vp 1 2",         "g",        "s 1",        "vn 1 0 0"};
    hidden::TextLines lines;
    int v = 0;
    int f = 0;
    while (v < mesh.vertex_count() || f < mesh.faces.size()) {
        if (random() % 6 == 0)
            lines.push_back(others[random() % others.size()]);
        const bool vertex = f == mesh.faces.size() || random() % 3 != 0;
        if (vertex && v < mesh.vertex_count()) {
            lines.push_back(plain[static_cast<std::size_t>(v++)]);
            if (random() % 4 == 0) lines.back() += " 1";
            if (random() % 4 == 0) lines.back() += " 0.5 0.25 1";
        } else if (f < mesh.faces.size()) {
            lines.push_back("f");
            for (const int corner_vertex : mesh.faces[f++])
                lines.back() += " " + corner(random, corner_vertex, v);
        }
    }
    for (const auto& [a, b] : mesh.loose_edges)
        lines.push_back("l " + corner(random, a, v) + " " +
                        corner(random, b, v));
    return lines;
}

}  // namespace

TEST_CASE("meshes of all kinds are read", "[points:2]") {
    hint("Are order, corners and coordinates those of the text, to the last?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::file_meshes()) {
        const OnMesh on(fixture);
        const IndexedMesh awkward =
            hidden::with_awkward_positions(fixture.mesh, ++salt);
        for (const IndexedMesh& mesh : {fixture.mesh, awkward})
            CHECK(misread(hidden::joined(hidden::obj_lines(mesh)), mesh) == "");
    }
}

TEST_CASE("comments, blanks and line ends do not matter", "[points:2]") {
    hint("May `#` stand behind a number? What else is blank beside a space?");
    std::uint64_t salt = 100;
    for (const Fixture& fixture : hidden::file_meshes()) {
        const OnMesh on(fixture);
        const auto file =
            hidden::decorated(hidden::obj_lines(fixture.mesh), ++salt);
        CHECK(misread(file.text, fixture.mesh) == "");
    }
    CHECK(misread("", {}) == "");
    CHECK(misread("#\r\n \t\n", {}) == "");
    CHECK(misread("v 1 2 3", {{{1, 2, 3}}, {}, {}}) == "");
    CHECK(misread("v 1 2 3\r\nv\t4 5 6\r\n\r\n",
                  {{{1, 2, 3}, {4, 5, 6}}, {}, {}}) == "");
    CHECK(misread(after_four("f 4 3 1#2"),
                  with_faces({{3, 2, 0}, {0, 1, 2}})) == "");
}

TEST_CASE("vertices and faces mixed, in groups, in all ways of writing",
          "[points:2]") {
    hint("Do the numbers of the vertices begin anew anywhere in the file?");
    Random random(seed());
    for (const Fixture& fixture : hidden::file_meshes()) {
        const OnMesh on(fixture);
        const std::string text =
            hidden::joined(mixed_lines(fixture.mesh, random));
        CHECK(misread(text, fixture.mesh) == "");
    }
}

TEST_CASE("what stands behind a slash is not a vertex", "[points:1]") {
    hint("Up to where does the number of the vertex go?");
    for (const char* const face :
         {"f 4 2 1", "f 4/1 2/2 1/3", "f 4//1 2//1 1//2", "f 4/7/9 2/8/9 1/9/9",
          "f -1/-1 -3/-2 -4/-3", "f 4/1/1 2//1 1", "f\t4//-5 2/1  1/30/4 #/"})
        CHECK(misread(after_four(face), with_faces({{3, 1, 0}, {0, 1, 2}})) ==
              "");
}

TEST_CASE("numbers from the end, and of vertices that come later",
          "[points:2]") {
    hint("Which vertices count for -1, and when is it known which are there?");
    CHECK(
        misread("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -1 -2 -3\nv 0 1 0\nf -1 -2 -4\n",
                with_faces({{2, 1, 0}, {3, 2, 0}})) == "");
    CHECK(misread("f 1 2 3\n" + four + "f 1 3 4\n",
                  with_faces({{0, 1, 2}, {0, 2, 3}})) == "");
    CHECK(misread("v 0 0 0\nv 1 0 0\nf -2 4 -1\nv 1 1 0\nv 0 1 0\n",
                  with_faces({{0, 3, 1}})) == "");
    CHECK(refused_at("v 0 0 0\nv 1 0 0\nf 1 2 -3\nv 1 1 0\nv 0 1 0\n") == 3);
    CHECK(refused_at("f 1 2 -1\n" + four) == 1);
    CHECK(refused_at("l -1 1\n" + four) == 1);
    CHECK(refused_at("f 1 2 5\n" + four) == 1);
    CHECK(misread("l 4 1\n" + four, {four_positions, {}, {{3, 0}}}) == "");
}

TEST_CASE("lines are chains of loose edges", "[points:1]") {
    hint("How many edges does a line with n corners have?");
    using Edges = std::vector<std::array<int, 2>>;
    const auto edges = [](const std::string& lines) {
        return read_obj(four + lines).loose_edges;
    };
    CHECK(edges("l 1 2\n") == Edges{{0, 1}});
    CHECK(edges("l 2 1\nl 1 2\n") == Edges{{1, 0}, {0, 1}});
    CHECK(edges("l 1 2 3 4 1\n") == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    CHECK(edges("l 4/1 2/2 -4\nf 1 2 3\nl 3 3") ==
          Edges{{3, 1}, {1, 0}, {2, 2}});
    CHECK(edges("g a\nl 1 3\ng b\n") == Edges{{0, 2}});
}

TEST_CASE("keywords that are passed over, and others that are not",
          "[points:1]") {
    hint("Is the first letter of a line enough to know what it is?");
    for (const char* const line :
         {"vt 0 0", "vn 0 0 1", "vp 1", "p 1", "g", "g f 1 2 3", "o v", "s off",
          "usemtl l 1 2", "mtllib x y.mtl", "vt", "vn a b c", "s 1 # f 1 2 3"})
        CHECK(misread(after_four(line), with_faces({{0, 1, 2}})) == "");
    for (const char* const line :
         {"face 1 2 3", "vertex 0 0 0", "x", "F 1 2 3", "V 0 0 0", "v1 2 3",
          "f1 2 3", "fo 1 2 3", "1 2 3", "line 1 2", "L 1 2", "off", "gx 1",
          "vx 0 0 0", "v, 0 0 0", "vnn 0 0 1", "usemt a", "//"})
        CHECK(refused_at(after_four(line)) == 5);
}

TEST_CASE("numbers behind the coordinates are ignored", "[points:1]") {
    hint("How many of the numbers on a vertex's line say where it is?");
    for (const char* const rest : {"", " 1", " 0.5 0.5 0.5", " 1 0 0 1",
                                   " 255 0 0", " 9 8 7 6 # colour"})
        CHECK(misread("v 1 -2.5 3e1" + std::string(rest) + "\n",
                      {{{1, -2.5, 30}}, {}, {}}) == "");
    CHECK(misread("v .5 -5. 1E-2\nv 0.3 0.30000000000000004 1e300\n",
                  {{{0.5, -5, 0.01}, {0.3, 0.1 + 0.2, 1e300}}, {}, {}}) == "");
}

TEST_CASE("vertices that are none", "[points:2]") {
    hint("Was the whole word a number, and a finite one?");
    for (const char* const vertex :
         {"v",           "v 1",        "v 1 2",       "v a 0 0",
          "v 0 abc 0",   "v 0 0 c",    "v 1.5x 0 0",  "v 0 1-2 0",
          "v 0 0 1.2.3", "v 0,5 0 0",  "v 0, 0, 0",   "v nan 0 0",
          "v 0 inf 0",   "v 0 0 -inf", "v 1e999 0 0", "v 0 -1e999 0",
          "v 0 NaN 0",   "v 0 0 #0",   "v 0 0 -",     "v . 0 0",
          "v 1/1 0 0",   "v 0 1e 0"})
        CHECK(refused_at(after_four(vertex)) == 5);
}

TEST_CASE("faces and lines that are none", "[points:2]") {
    hint("What must hold of the number of corners, and of each corner?");
    for (const char* const wrong :
         {"f",           "f 1",         "f 1 2",         "f 1 2 #3",
          "f 1 2 0",     "f 0 1 2",     "f 1 5 2",       "f 1 2 -5",
          "f -5 1 2",    "f 1 2 100",   "f 1 2 x",       "f 1 2.0 3",
          "f 1 2x 3",    "f 1 2 /3",    "f / 1 2",       "f 1 2 //3",
          "f 1 2 3 4 5", "f 1, 2, 3",   "f 1 2 - 3",     "f a/1 b/1 c/1",
          "f 2x/1 2 3",  "f 1.5/1 2 3", "f 0/1 1/1 2/1", "f 5//1 1//1 2//1",
          "f 1 2 nan",   "f 1/1 2/2",   "f 1 2 3 0",     "f 1e0 2 3"})
        CHECK(refused_at(after_four(wrong)) == 5);
    for (const char* const wrong :
         {"l", "l 1", "l 1 0", "l 1 5", "l 5 1", "l -5 1", "l 1 x", "l 1 2 5",
          "l 1 2.5", "l 1 #2", "l 1/2", "l 0/1 2/1", "l 1 2 3 4 -5"})
        CHECK(refused_at(after_four(wrong)) == 5);
}

TEST_CASE("corners met twice, vertices that nothing names", "[points:1]") {
    hint("Is it the reader's business which vertices the faces use?");
    CHECK(misread(after_four("f 1 3 1 4"),
                  with_faces({{0, 2, 0, 3}, {0, 1, 2}})) == "");
    CHECK(misread(after_four("f 2 2 2\nf 2 2 2"),
                  with_faces({{1, 1, 1}, {1, 1, 1}, {0, 1, 2}})) == "");
    CHECK(misread(four, with_faces({})) == "");
}

TEST_CASE("of several defects, the line of the first", "[points:2]") {
    hint("Which defects do you find out about only at the end of the text?");
    CHECK(refused_at(after_four("f 1 2 5\nf 1 x 3")) == 5);
    CHECK(refused_at(after_four("f 1 2 3\nf 1 2 9\nv 0 0")) == 6);
    CHECK(refused_at(after_four("l 1 9\nfoo\nf 1 2 3 9")) == 5);
    CHECK(refused_at(after_four("f 1 2 -9\nf 1 2 9")) == 5);
    CHECK(refused_at(after_four("f 1 2 9\nf 1 2 -9")) == 5);
    CHECK(refused_at(after_four("l 1 7\nf 1 2 8\nl 1 9")) == 5);
    CHECK(refused_at(after_four("f 1 2 8\nl 1 9\nf 1 2 3")) == 5);
    CHECK(refused_at(after_four("foo\nf 1 2 9")) == 5);
    CHECK(refused_at(after_four("v nan 0 0\nv 0\nf 1 2")) == 5);
    CHECK(refused_at("f 1 2 5\nv 0 0 x\n" + four) == 2);
    CHECK(refused_at("f 1 2 6\nv 0 0 x\n" + four) == 1);
}

TEST_CASE("the line of a defect among comments and blank lines", "[points:2]") {
    hint("Which lines count, those with something on them or all?");
    std::uint64_t salt = 200;
    for (const Fixture& fixture :
         {zoo::slide(), zoo::dangling(), zoo::torus7()}) {
        const OnMesh on(fixture);
        const hidden::TextLines lines = hidden::obj_lines(fixture.mesh);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            hidden::TextLines damaged = lines;
            damaged[k].back() = 'x';
            const auto file = hidden::decorated(damaged, ++salt);
            CHECK(refused_at(file.text) == file.number[k]);
        }
    }
}

TEST_CASE("a large file", "[points:1][once]") {
    hint("How often is the whole text, or the mesh so far, looked through?");
    const IndexedMesh mesh =
        hidden::with_awkward_positions(grid(120, 120, Cells::triangles), 300);
    CHECK(misread(hidden::joined(hidden::obj_lines(mesh)), mesh) == "");
}
