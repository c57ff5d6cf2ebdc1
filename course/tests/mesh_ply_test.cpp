// PLY files, read back here by hand; and files told apart by extension.
#include "course/mesh/ply.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>

#include "course/mesh/mesh_file.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"
#include "course/tests/mesh_files.h"

using namespace course;

namespace {

using limits = std::numeric_limits<double>;

std::string written(const IndexedMesh& mesh, PlyFormat format) {
    const TemporaryFolder folder;
    write_ply(folder / "mesh.ply", mesh, format);
    return content(folder / "mesh.ply");
}

/// What stands after the head.
std::string body(const std::string& ply) {
    const std::string end = "end_header\n";
    return ply.substr(ply.find(end) + end.size());
}

/// Numbers of a binary body, in sequence. On machines that have the lowest byte
/// first, as all on which this test is run.
class Bytes {
public:
    explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}

    template <class Number>
    Number next() {
        Number number{};
        REQUIRE(at_ + sizeof number <= bytes_.size());
        std::memcpy(&number, bytes_.data() + at_, sizeof number);
        at_ += sizeof number;
        return number;
    }
    bool is_done() const { return at_ == bytes_.size(); }

private:
    std::string bytes_;
    std::size_t at_ = 0;
};

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Numbers that are easily lost, and random ones.
std::vector<double> numbers() {
    std::vector<double> all = {
        0.0,    -0.0,          0.1,           1.0 / 3,          1e308,
        -1e308, limits::max(), limits::min(), limits::lowest(), 5e-324,
        1e-310, 2.5e-310,      1e22,          123456789.125,    1e-5};
    Random random(41);
    while (all.size() < 3000) {
        const std::uint64_t bits = random();
        double x = 0;
        std::memcpy(&x, &bits, sizeof x);
        if (std::isfinite(x)) all.push_back(x);
    }
    return all;
}

IndexedMesh cloud(const std::vector<double>& x) {
    IndexedMesh mesh;
    for (std::size_t k = 0; k + 2 < x.size(); k += 3)
        mesh.positions.push_back({x[k], x[k + 1], x[k + 2]});
    return mesh;
}

IndexedMesh polygon(int sides) {
    IndexedMesh mesh;
    std::vector<int> face;
    for (int v = 0; v < sides; ++v) {
        face.push_back(v);
        mesh.positions.push_back({static_cast<double>(v), 0, 0});
    }
    mesh.faces.push_back(face);
    return mesh;
}

}  // namespace

TEST_CASE("a PLY file has a head, vertices, faces and loose edges") {
    const IndexedMesh mesh{{{0.1, 0, -0.0}, {1, 0, 0}, {1, 1, 0}, {0, 1e22, 0}},
                           {{0, 1, 2}, {0, 1, 2, 3}},
                           {{{3, 1}}}};
    CHECK(written(mesh, PlyFormat::ascii) ==
          "ply\nformat ascii 1.0\n"
          "element vertex 4\n"
          "property double x\nproperty double y\nproperty double z\n"
          "element face 2\nproperty list uchar int vertex_indices\n"
          "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
          "end_header\n"
          "0.1 0 -0\n1 0 0\n1 1 0\n0 1e+22 0\n"
          "3 0 1 2\n4 0 1 2 3\n3 1\n");
    CHECK(written({}, PlyFormat::ascii) ==
          "ply\nformat ascii 1.0\nelement vertex 0\n"
          "property double x\nproperty double y\nproperty double z\n"
          "element face 0\nproperty list uchar int vertex_indices\n"
          "end_header\n");
}

TEST_CASE("a binary PLY file has the same as bytes, the lowest first") {
    const IndexedMesh mesh{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}, {{{2, 1}}}};
    const std::string ply = written(mesh, PlyFormat::binary);
    CHECK(contains(ply, "ply\nformat binary_little_endian 1.0\n"));
    CHECK(body(ply).size() == 9 * 8 + 1 + 3 * 4 + 2 * 4);
    CHECK(body(ply).substr(0, 8) == std::string("\0\0\0\0\0\0\xF0\x3F", 8));
    Bytes bytes(body(ply));
    for (const Vec3& p : mesh.positions)
        for (const double x : {p.x, p.y, p.z}) CHECK(bytes.next<double>() == x);
    CHECK(bytes.next<std::uint8_t>() == 3);
    for (const int v : {0, 1, 2, 2, 1}) CHECK(bytes.next<std::int32_t>() == v);
    CHECK(bytes.is_done());
}

TEST_CASE("faces of more than 255 sides are counted in four bytes") {
    CHECK(contains(written(polygon(255), PlyFormat::binary), "list uchar int"));
    const std::string ply = written(polygon(256), PlyFormat::binary);
    CHECK(contains(ply, "property list uint int vertex_indices\n"));
    Bytes bytes(body(ply).substr(256 * 24));
    CHECK(bytes.next<std::uint32_t>() == 256);
    for (int v = 0; v < 256; ++v) CHECK(bytes.next<std::int32_t>() == v);
    CHECK(bytes.is_done());
    CHECK(contains(written(polygon(256), PlyFormat::ascii), "\n256 0 1 2 "));
}

TEST_CASE("positions of both forms of PLY come back to the last bit") {
    const std::vector<double> all = numbers();
    const IndexedMesh mesh = cloud(all);
    Bytes bytes(body(written(mesh, PlyFormat::binary)));
    std::istringstream words(body(written(mesh, PlyFormat::ascii)));
    for (std::size_t k = 0; k < 3 * mesh.positions.size(); ++k) {
        std::string word;
        words >> word;
        double x = 0;
        std::from_chars(word.data(), word.data() + word.size(), x);
        INFO(word);
        REQUIRE(same_bits(x, all[k]));
        REQUIRE(same_bits(bytes.next<double>(), all[k]));
    }
    CHECK(bytes.is_done());
}

TEST_CASE("OBJ and OFF files give the hardest positions back, to the bit") {
    const std::vector<double> all = numbers();
    const TemporaryFolder folder;
    for (const char* name : {"mesh.obj", "mesh.off"}) {
        write_mesh(folder / name, cloud(all));
        const IndexedMesh back = read_mesh(folder / name);
        REQUIRE(back.positions.size() == all.size() / 3);
        for (std::size_t v = 0; v < back.positions.size(); ++v) {
            REQUIRE(same_bits(back.positions[v].x, all[3 * v]));
            REQUIRE(same_bits(back.positions[v].y, all[3 * v + 1]));
            REQUIRE(same_bits(back.positions[v].z, all[3 * v + 2]));
        }
    }
}

TEST_CASE("a mesh that PLY cannot hold is refused, and no file appears") {
    const TemporaryFolder folder;
    IndexedMesh mesh = zoo::lens().mesh;
    mesh.positions[0].x = std::nan("");
    CHECK_THROWS_AS(write_ply(folder / "mesh.ply", mesh),
                    std::invalid_argument);
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK_THROWS_AS(write_ply(folder / "none" / "mesh.ply", {}), MeshFileError);
}

TEST_CASE("files are told apart by their extension, in capitals or not") {
    const TemporaryFolder folder;
    const IndexedMesh mesh = zoo::house().mesh;
    for (const char* name : {"a.obj", "a.off", "A.OBJ", "A.OFF"}) {
        write_mesh(folder / name, mesh);
        CHECK(read_mesh(folder / name) == mesh);
    }
    CHECK(content(folder / "A.OFF").substr(0, 3) == "OFF");
    write_mesh(folder / "a.ply", mesh);
    CHECK(content(folder / "a.ply").substr(0, 3) == "ply");
}

TEST_CASE("a file of another kind is refused by its extension") {
    CHECK_THROWS_WITH(read_mesh("bunny.ply"),
                      "bunny.ply: the extension is `.ply`, expected .obj or "
                      ".off");
    CHECK_THROWS_WITH(write_mesh("bunny", {}),
                      "bunny: the extension is ``, expected .obj, .off or "
                      ".ply");
}
