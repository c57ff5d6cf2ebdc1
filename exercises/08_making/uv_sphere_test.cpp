#include "exercises/08_making/uv_sphere.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("four meridians and two bands make an octahedron", "[points:1]") {
    hint(
        "Which six points are the vertices, and how many triangles are there?");
    const IndexedMesh mesh = uv_sphere(4, 2);
    CHECK(mesh.faces.size() == 8);
    REQUIRE(mesh.vertex_count() == 6);
    std::vector<Vec3> sorted = mesh.positions;
    const auto key = [](Vec3 p) {
        return std::lround(100 * p.z + 10 * p.x + p.y);
    };
    std::sort(sorted.begin(), sorted.end(),
              [&](Vec3 a, Vec3 b) { return key(a) < key(b); });
    CHECK_THAT(sorted, AreAt({{0, 0, -1},
                              {-1, 0, 0},
                              {0, -1, 0},
                              {0, 1, 0},
                              {1, 0, 0},
                              {0, 0, 1}},
                             1));
}

TEST_CASE("the triangles look outwards", "[points:1]") {
    hint("Seen from outside, which way round do the corners run?");
    const IndexedMesh mesh = uv_sphere(6, 4);
    REQUIRE(mesh.faces.size() == 36);
    for (const FaceList::Face face : mesh.faces) {
        REQUIRE(face.size() == 3);
        for (const int v : face) REQUIRE((0 <= v && v < mesh.vertex_count()));
        const auto at = [&](int k) {
            return mesh.positions[static_cast<std::size_t>(
                face[static_cast<std::size_t>(k)])];
        };
        const Vec3 normal = cross(at(1) - at(0), at(2) - at(0));
        CHECK(dot(normal, at(0) + at(1) + at(2)) > 0);
    }
}

TEST_CASE("one band is no sphere", "[points:1]") {
    hint("What would a sphere of one band, or of two meridians, look like?");
    CHECK_THROWS_AS(uv_sphere(4, 1), std::invalid_argument);
}
