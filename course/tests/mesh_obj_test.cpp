// OBJ files: what is read, every trap of the parser behind it, and what is
// said of bad files.
#include "course/mesh/obj.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_files.h"

namespace {

using namespace course;

/// Four vertices on lines 1 to 4.
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

IndexedMesh read(std::string_view text) {
    const TemporaryFolder folder;
    return read_obj(file_of(folder, text));
}

std::vector<FileDefect> defects(std::string_view text) {
    return defects_of(read_obj, text);
}

/// The only defect of the text, as `line: what`.
std::string defect(std::string_view text) {
    const std::vector<FileDefect> all = defects(text);
    if (all.size() != 1) return std::to_string(all.size()) + " defects";
    return std::to_string(all[0].line) + ": " + all[0].what;
}

IndexedMesh round_trip(const IndexedMesh& mesh) {
    const TemporaryFolder folder;
    write_obj(folder / "mesh.obj", mesh);
    return read_obj(folder / "mesh.obj");
}

/// A polygon of n sides, as text.
std::string polygon(int n) {
    std::string text;
    for (int v = 0; v < n; ++v) text += "v " + std::to_string(v) + " 0 0\n";
    text += "f";
    for (int v = 1; v <= n; ++v) text += " " + std::to_string(v);
    return text + "\n";
}

/// Numbers as 1.234,5.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_CASE("an OBJ file gives vertices, faces of any degree and loose edges") {
    const IndexedMesh mesh = read(square +
                                  "v 2 0.5 -1e1\n"
                                  "f 1 2 3 4\n"
                                  "l 3 5\n"
                                  "f 2 5 3\n");
    CHECK(mesh.positions ==
          std::vector<Vec3>{
              {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, -10}});
    CHECK(mesh.faces == FaceList{{0, 1, 2, 3}, {1, 4, 2}});
    CHECK(mesh.loose_edges == std::vector<std::array<int, 2>>{{2, 4}});
}

TEST_CASE("faces of several objects, groups and materials stay in file order") {
    const IndexedMesh mesh = read("o one\n" + square +
                                  "g a\nusemtl red\nf 1 2 3\nl 1 2\n"
                                  "g b c\nusemtl blue\nf 1 3 4\n"
                                  "o two\nl 3 4\ng\nf 2 3 4\n"
                                  "g a\ns off\nf 1 2 4\n");
    CHECK(mesh.faces == FaceList{{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {0, 1, 3}});
    CHECK(mesh.loose_edges == std::vector<std::array<int, 2>>{{0, 1}, {2, 3}});
}

TEST_CASE("a polyline becomes one loose edge for each two of its vertices") {
    CHECK(read(square + "l 1 2 3 4\nl -1 -4\n").loose_edges ==
          std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

TEST_CASE("negative indices count back from the line they stand on") {
    CHECK(read(square + "f -4 -3 -2\nv 9 9 9\nf -1 -5 -4\n").faces ==
          FaceList{{0, 1, 2}, {4, 0, 1}});
}

TEST_CASE("indices of texture and normal are passed over") {
    const std::string text =
        square + "vt 0 0\nvt 1 1\nvn 0 0 1\n" +
        "f 1/1 2/2 3/1\nf 1//1 3//-1 4//1\nf 1/1/1 2/-1/1 4/2/1\nl 1/1 2/2\n";
    CHECK(read(text).faces == FaceList{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
    CHECK(read(text).loose_edges.size() == 1);
}

TEST_CASE("a face may name vertices that come after it") {
    CHECK(read("f 1/1 2/1 3/1\nvt 0 0\n" + square).faces ==
          FaceList{{0, 1, 2}});
}

TEST_CASE("a fourth coordinate and colours are passed over") {
    const IndexedMesh mesh =
        read("v 1 2 3 1\nv 1 2 3 0.5 0.5 1\nv 1 2 3 1 0.5 0.5 1\n");
    CHECK(mesh.positions == std::vector<Vec3>(3, {1, 2, 3}));
}

TEST_CASE("polygons of 256, 300 and 70000 sides keep their sides") {
    for (const int n : {255, 256, 300, 70'000}) {
        const IndexedMesh mesh = read(polygon(n));
        REQUIRE(mesh.faces.size() == 1);
        REQUIRE(mesh.faces[0].size() == static_cast<std::size_t>(n));
        CHECK(mesh.faces[0].front() == 0);
        CHECK(mesh.faces[0].back() == n - 1);
    }
}

TEST_CASE("line ends, blanks, comments and continued lines do not matter") {
    const IndexedMesh expected = read(square + "f 1 2 3 4\nf 1 3 4\n");
    const auto same = [&](const std::string& text) {
        CHECK(read(text) == expected);
    };
    std::string crlf;
    std::string cr;
    for (const char c : square + "f 1 2 3 4\nf 1 3 4\n") {
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    same(crlf);
    same(cr);
    same(square + "f 1 2 3 4\nf 1 3 4");
    same(square + "\n\n  f\t1  2\t3 4  \n\t\nf 1 3 4");
    same("# a square\n" + square + "f 1 2 3 4 # a face\n# f 1\nf 1 3 4#\n");
    same(square + "f 1 2 \\\n3 \\\r\n 4\nf 1 3 4\n");
    same("# a path C:\\\n" + square + "f 1 2 3 4\nf 1 3 4\n");
    same("\xEF\xBB\xBF" + square + "f 1 2 3 4\nf 1 3 4\n");
}

TEST_CASE("the line of a defect counts every line end once") {
    CHECK(defect("\r\n# x\n\rv 0 x 0\n") == "4: v: `x` is not a number");
    CHECK(defects(square + "f 1 \\\n2\n\nf 9 1 2\n")[0].line == 5);
    CHECK(defects(square + "f 1 \\\n2\n\nf 9 1 2\n").back().line == 8);
}

TEST_CASE("an empty OBJ file is an empty mesh, vertices alone a point cloud") {
    CHECK(read("") == IndexedMesh{});
    CHECK(read("# nothing\n\n") == IndexedMesh{});
    CHECK(read(square).vertex_count() == 4);
    CHECK(read(square).faces.empty());
}

TEST_CASE("coordinates are the nearest doubles, whatever the locale") {
    const TemporaryFolder folder;
    const std::filesystem::path file =
        file_of(folder, "v 0.979434 -0.743506 1e-310\nv +1 +.5 -1234.5");
    const std::locale saved = std::locale::global(
        std::locale(std::locale::classic(), new DecimalComma));
    const IndexedMesh mesh = read_obj(file);
    write_obj(folder / "back.obj", mesh);
    std::locale::global(saved);
    CHECK(content(folder / "back.obj") ==
          "v 0.979434 -0.743506 1e-310\nv 1 0.5 -1234.5\n");
    CHECK(same_bits(mesh.positions[0].x, 0.979434));
    CHECK(same_bits(mesh.positions[0].y, -0.743506));
    CHECK(same_bits(mesh.positions[0].z, 1e-310));
    CHECK(mesh.positions[1] == Vec3{1, 0.5, -1234.5});
}

TEST_CASE("a coordinate that is no finite number is reported, not read as 0") {
    CHECK(defect("v 0 abc 0\n") == "1: v: `abc` is not a number");
    CHECK(defect("v 0 0 1x\n") == "1: v: `1x` is not a number");
    CHECK(defect("v 0,5 0 0\n") == "1: v: `0,5` is not a number");
    CHECK(defect("v 0 0 nan\n") == "1: v: `nan` is not a finite number");
    CHECK(defect("v -inf 0 0\n") == "1: v: `-inf` is not a finite number");
    CHECK(defect("v 0 1e999 0\n") ==
          "1: v: `1e999` is too large or too small for a number");
    CHECK(defect("v 0 0 +-1\n") == "1: v: `+-1` is not a number");
    CHECK(defect("v 0 0 0 red\n") == "1: v: `red` is not a number");
    CHECK(defects("v a nan c\n").size() == 3);
}

TEST_CASE("too few or too many coordinates are reported") {
    const std::string expected =
        ", expected x y z (then perhaps w, or a "
        "colour)";
    CHECK(defect("v\n") == "1: v has 0 numbers" + expected);
    CHECK(defect("v 1\n") == "1: v has 1 number" + expected);
    CHECK(defect("\nv 1 2\n") == "2: v has 2 numbers" + expected);
    CHECK(defect("v 1 2 3 4 5\n") == "1: v has 5 numbers" + expected);
    CHECK(defect("v 1 2 3 4 5 6 7 8\n") == "1: v has 8 numbers" + expected);
}

TEST_CASE("an index of nothing in the file is reported") {
    CHECK(defect(square + "f 1 2 5\n") ==
          "5: corner 3 is 5, but the file has 4 vertices (v)");
    CHECK(defect("f 1 2 5\n" + square) ==
          "1: corner 3 is 5, but the file has 4 vertices (v)");
    CHECK(defect(square + "f -5 1 2\n") ==
          "5: corner 1 is -5, but only 4 vertices (v) come before it");
    CHECK(defect("f -1 1 2\n" + square) ==
          "1: corner 1 is -1, but only 0 vertices (v) come before it");
    CHECK(defect(square + "l 1 9\n") ==
          "5: corner 2 is 9, but the file has 4 vertices (v)");
    CHECK(defect(square + "f 1/1 2/1 3/2\nvt 0 0\n") ==
          "5: corner 3 is 2, but the file has 1 texture coordinates (vt)");
    CHECK(defect(square + "f 1//1 2//1 3//-2\nvn 0 0 1\n") ==
          "5: corner 3 is -2, but only 0 normals (vn) come before it");
    CHECK(defect(square + "vn 0 0 1\nf 1//1 2//1 3//-2\n") ==
          "6: corner 3 is -2, but only 1 normals (vn) come before it");
}

TEST_CASE("an index 0 or one that is no number is reported") {
    CHECK(defect(square + "f 0 1 2\n") ==
          "5: f: corner 1: `0` has an index 0, but they begin at 1");
    CHECK(defect(square + "vt 0 0\nf 1/0 2/1 3/1\n") ==
          "6: f: corner 1: `1/0` has an index 0, but they begin at 1");
    CHECK(defect(square + "f 1 2 3x\n") ==
          "5: f: corner 3: `3x` is not a whole number");
    CHECK(defect(square + "f 1 2 c\n") ==
          "5: f: corner 3: `c` is not a whole number");
    CHECK(defect(square + "f 1 2 3.0\n") ==
          "5: f: corner 3: `3.0` is not a whole number");
    CHECK(defect(square + "f 1 2 99999999999\n") ==
          "5: f: corner 3: `99999999999` is too large for a whole number");
    CHECK(defect(square + "f 1/ 2 3\n") ==
          "5: f: corner 1: `1/` lacks an index beside a slash");
    CHECK(defect(square + "f 1// 2 3\n") ==
          "5: f: corner 1: `1//` lacks an index beside a slash");
    CHECK(defect(square + "f /1 2 3\n") ==
          "5: f: corner 1: `/1` lacks an index beside a slash");
    CHECK(defect(square + "f 1/1/1/1 2 3\n") ==
          "5: f: corner 1: `1/1/1/1` has more than three parts");
    CHECK(defect(square + "l 1 b\n") ==
          "5: l: corner 2: `b` is not a whole number");
}

TEST_CASE("faces of fewer than three corners are reported, not dropped") {
    CHECK(defect(square + "f\n") == "5: f has 0 corners, expected at least 3");
    CHECK(defect(square + "f 1\n") == "5: f has 1 corner, expected at least 3");
    CHECK(defect(square + "f 1 2\n") ==
          "5: f has 2 corners, expected at least 3");
    CHECK(defect(square + "l\n") == "5: l has 0 corners, expected at least 2");
    CHECK(defect(square + "l 1\n") == "5: l has 1 corner, expected at least 2");
}

TEST_CASE("what says nothing about vertices, faces and lines is passed over") {
    const IndexedMesh expected = read(square + "f 1 2 3\n");
    for (const char* keyword :
         {"vp", "p", "g", "s", "o", "mg", "lod", "usemtl", "mtllib", "usemap",
          "maplib", "bevel", "c_interp", "d_interp", "shadow_obj",
          "trace_obj"}) {
        CAPTURE(keyword);
        CHECK(read(square + keyword + " 1\n" + "f 1 2 3\n") == expected);
    }
}

TEST_CASE("unknown keywords are reported") {
    CHECK(defect("face 1 2 3\n") == "1: `face` is no keyword known here");
    CHECK(defect("V 1 2 3\n") == "1: `V` is no keyword known here");
    CHECK(defect("surf 0 1 0 1 1 2 3 4\n") ==
          "1: `surf` is no keyword known here");
    CHECK(defect(std::string("\x89PNG\x1b[2J\x7f, and so on\n")) ==
          "1: `?PNG?[2J?,` is no keyword known here");
    CHECK(defect(std::string(100, 'x')) ==
          "1: `xxxxxxxxxxxxxxxxxxxxxxxx...` is no keyword known here");
    CHECK(defect(square + std::string("f 1 2 3\0 4\n", 11)) ==
          "5: f: corner 3: `3?` is not a whole number");
    CHECK(defect(square + "f 1 2 3 \\") == "5: the file ends after a `\\`");
}

TEST_CASE("all defects are reported, by line, each with its file") {
    const std::string text =
        "v 0 0 zero\n"    // 1
        "v 0 0\n"         // 2
        "v 1 1 1\n"       // 3
        "f 1 9 x\n"       // 4: two
        "f 8 2\n"         // 5: two
        "l 1\n"           // 6
        "face 1 2 3\n"    // 7
        "f 1 2 3\n"       // 8: good, bad vertices count
        "f 1/1 2 3//0\n"  // 9: two
        "v inf 0 0";      // 10
    std::vector<int> lines;
    for (const FileDefect& d : defects(text)) lines.push_back(d.line);
    CHECK(lines == std::vector<int>{1, 2, 4, 4, 5, 5, 6, 7, 9, 9, 10});
    const TemporaryFolder folder;
    const std::filesystem::path file = file_of(folder, text);
    const std::string message = message_of([&] { read_obj(file); });
    CHECK(contains(message, file.string() + ":1: v: `zero` is not a number\n" +
                                file.string() + ":2: v has 2 numbers"));
    CHECK(contains(message, file.string() + ":10: v: `inf`"));
}

TEST_CASE("a file that is not there or is a folder is reported by name") {
    const TemporaryFolder folder;
    const std::filesystem::path missing = folder / "missing.obj";
    CHECK(contains(message_of([&] { read_obj(missing); }),
                   missing.string() + ": cannot be read: "));
    CHECK(contains(message_of([&] { read_obj(folder.path()); }),
                   "cannot be read: "));
    CHECK_THROWS_AS(read_obj(missing), MeshFileError);
}

TEST_CASE("every mesh of the zoo and of the generators survives a round trip") {
    for (const Fixture& fixture : zoo::with_table()) {
        CAPTURE(fixture.name);
        CHECK(round_trip(fixture.mesh) == fixture.mesh);
    }
    for (const IndexedMesh& mesh :
         {icosphere(3), torus(9, 7), random_polygons(5), IndexedMesh{}})
        CHECK(round_trip(mesh) == mesh);
}

TEST_CASE("positions survive a round trip to the last bit") {
    std::mt19937_64 random(11);
    IndexedMesh mesh;
    while (mesh.vertex_count() < 3000) {
        double p[3];
        for (double& x : p) {
            const std::uint64_t bits = random();
            std::memcpy(&x, &bits, sizeof x);
        }
        if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
            mesh.positions.push_back({p[0], p[1], p[2]});
    }
    using limits = std::numeric_limits<double>;
    mesh.positions.push_back({-0.0, limits::denorm_min(), limits::max()});
    mesh.positions.push_back({0.1, 1.0 / 3, limits::lowest()});
    const IndexedMesh back = round_trip(mesh);
    REQUIRE(back.positions.size() == mesh.positions.size());
    bool same = true;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        same = same && same_bits(mesh.positions[v].x, back.positions[v].x) &&
               same_bits(mesh.positions[v].y, back.positions[v].y) &&
               same_bits(mesh.positions[v].z, back.positions[v].z);
    CHECK(same);
}

TEST_CASE(
    "an OBJ file is written with indices from 1 and the shortest digits") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "mesh.obj";
    IndexedMesh mesh{{{0.1, 0.2, -0.3}, {1, 0, 0}, {1e30, 1, 0}, {0, 1, 0}},
                     {{0, 1, 2}},
                     {{{2, 3}}}};
    write_obj(file, mesh);
    CHECK(content(file) ==
          "v 0.1 0.2 -0.3\nv 1 0 0\nv 1e+30 1 0\nv 0 1 0\nf 1 2 3\nl 3 4\n");
    mesh.positions[0] = {5, 5, 5};
    write_obj(file, mesh);
    CHECK(read_obj(file) == mesh);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()),
                        {}) == 1);
}

TEST_CASE("a failed write leaves the old file and nothing else") {
    const TemporaryFolder folder;
    const std::filesystem::path taken = folder / "taken";
    std::filesystem::create_directories(taken / "inside");
    CHECK_THROWS_AS(write_obj(taken, icosphere(0)), MeshFileError);
    CHECK(
        contains(message_of([&] { write_obj(folder / "no" / "mesh.obj", {}); }),
                 "mesh.obj: cannot be written: "));
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()),
                        {}) == 1);
}

TEST_CASE("meshes that no file can hold are refused, and no file appears") {
    const TemporaryFolder folder;
    const IndexedMesh good{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{{0, 1}}}};
    const auto refuses = [&](auto spoil, const char* message) {
        IndexedMesh mesh = good;
        spoil(mesh);
        CHECK_THROWS_WITH(write_obj(folder / "mesh.obj", mesh), message);
    };
    refuses([](IndexedMesh& m) { m.positions[1].y = std::nan(""); },
            "vertex 1 is at (1, nan, 0), expected finite numbers");
    refuses(
        [](IndexedMesh& m) {
            m.faces.push_back({0, 1});
        },
        "face 1 has 2 corners, expected at least 3");
    refuses(
        [](IndexedMesh& m) {
            m.faces.push_back({0, 1, 3});
        },
        "face 1 names vertex 3, but the mesh has 3 vertices, from 0");
    refuses(
        [](IndexedMesh& m) {
            m.loose_edges.push_back({-1, 0});
        },
        "loose edge 1 names vertex -1, but the mesh has 3 vertices, from "
        "0");
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK_NOTHROW(write_obj(folder / "mesh.obj", good));
}

TEST_CASE("a file that is no mesh at all gives a thousand defects, no more") {
    std::string text;
    for (int k = 0; k < 5000; ++k) text += "x\n";
    const std::vector<FileDefect> all = defects(text);
    REQUIRE(all.size() == 1001);
    CHECK(all[999].line == 1000);
    CHECK(all[1000] == FileDefect{0, "and 4000 more"});
}
