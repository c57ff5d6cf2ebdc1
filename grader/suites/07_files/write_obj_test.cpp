// Hidden suite of write_obj. What comes back is read by a reader of our own.
#include "exercises/07_files/write_obj.h"

#include <cmath>
#include <limits>
#include <utility>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/07_files/mesh_text.h"

using namespace course;

namespace {

/// How what was written for the mesh differs from it, or why it is no OBJ file,
/// or "".
std::string lost(const IndexedMesh& mesh) {
    const hidden::ReadBack back = hidden::obj_read_back(write_obj(mesh));
    return back.wrong.empty() ? hidden::mesh_difference(back.mesh, mesh)
                              : back.wrong;
}

IndexedMesh points(std::vector<Vec3> positions) {
    return {std::move(positions), {}, {}};
}

}  // namespace

TEST_CASE("vertices and faces of meshes of all kinds", "[points:2]") {
    hint("Is there a line for each vertex, each face, each corner in order?");
    for (const Fixture& fixture : hidden::file_meshes()) {
        const OnMesh on(fixture);
        CHECK(lost(fixture.mesh) == "");
    }
}

TEST_CASE("coordinates of all sizes, to the last bit", "[points:2]") {
    hint("How many digits does a double need, from its first one on?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::file_meshes()) {
        const OnMesh on(fixture);
        CHECK(lost(hidden::with_awkward_positions(fixture.mesh, ++salt)) == "");
    }
}

TEST_CASE("ten thousand numbers that need all their digits",
          "[points:1][once]") {
    hint("Are 15 or 16 digits enough for every double?");
    IndexedMesh mesh = points(std::vector<Vec3>(3500));
    CHECK(lost(hidden::with_awkward_positions(mesh, 100)) == "");
    double x = 0.1;
    for (Vec3& p : mesh.positions) {
        p = {x, std::nextafter(x, 2), -x};
        x = std::nextafter(x + 0.00025, 2);
    }
    CHECK(lost(mesh) == "");
}

TEST_CASE("very large and very small numbers, and -0.0", "[points:1]") {
    hint("Where do the digits of a very small number begin?");
    using limits = std::numeric_limits<double>;
    CHECK(lost(points({{limits::max(), limits::lowest(), limits::min()}})) ==
          "");
    CHECK(lost(points(
              {{1e-20, -1e-200, 1e22}, {1e200, 123456789.125, 1e15}})) == "");
    CHECK(lost(points({{limits::denorm_min(), -1e-310, limits::epsilon()}})) ==
          "");
    CHECK(lost(points({{-0.0, 0.0, -0.0}})) == "");
    CHECK(lost(points({{1e5, 1e6, 1e7}, {1234567, 100000, 1e16}})) == "");
    CHECK(lost(points({{9007199254740993.0, 0.1, -1.0 / 3}})) == "");
}

TEST_CASE("no faces, no vertices, vertices that no face uses", "[points:1]") {
    hint("Does every vertex have a line, whoever uses it?");
    CHECK(lost({}) == "");
    CHECK(lost(points({{1, 2, 3}})) == "");
    IndexedMesh mesh = points({{9, 9, 9},
                               {0, 0, 0},
                               {1, 0, 0},
                               {0, 1, 0},
                               {8, 8, 8},
                               {0, 0, 0},
                               {7, 7, 7}});
    mesh.faces = {{1, 2, 3}};
    CHECK(lost(mesh) == "");
    mesh.faces = {{3, 2, 1}, {1, 2, 3}, {1, 2, 3}, {5, 2, 5, 3}, {2, 2, 2}};
    CHECK(lost(mesh) == "");
}

TEST_CASE("loose edges, in order, from end to end", "[points:2]") {
    hint("Which line says that there is an edge that has no face?");
    for (const Fixture& fixture : hidden::file_meshes()) {
        if (fixture.mesh.loose_edges.empty()) continue;
        const OnMesh on(fixture);
        IndexedMesh mesh = fixture.mesh;
        CHECK(lost(mesh) == "");
        for (auto& [a, b] : mesh.loose_edges) std::swap(a, b);
        CHECK(lost(mesh) == "");
        mesh.faces = {};
        CHECK(lost(mesh) == "");
    }
    IndexedMesh mesh = zoo::cube().mesh;
    mesh.loose_edges = {{0, 6}, {6, 0}, {6, 1}, {1, 2}, {0, 6}, {5, 5}, {7, 3}};
    CHECK(lost(mesh) == "");
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How often is what you have written so far copied?");
    const IndexedMesh mesh =
        hidden::with_awkward_positions(grid(150, 150, Cells::triangles), 200);
    CHECK(lost(mesh) == "");
}
