#include "exercises/08_making/triangulate.h"

#include "course/halfedge/build.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Each triangle begun at its smallest corner, the triangles in order.
Triangles sorted(Triangles triangles) {
    for (auto& corners : triangles)
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

Fixture fixture(const std::string& name, const std::vector<Vec3>& polygon) {
    IndexedMesh mesh{polygon, {}, {}};
    std::vector<int> face;
    for (int v = 0; v < mesh.vertex_count(); ++v) face.push_back(v);
    mesh.faces.push_back(face);
    return {name, mesh, build(mesh)};
}

}  // namespace

TEST_CASE("a quad with a reflex corner", "[points:1]") {
    hint("On which side of the outline does the cut from 1 to 3 run?");
    const std::vector<Vec3> dart = {{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {0, 3, 0}};
    const Fixture drawn = fixture("dart", dart);
    const OnMesh on(drawn);
    CHECK(sorted(triangulate(dart)) == Triangles{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a triangle with one more corner on a side", "[points:1]") {
    hint("Which three of these four corners make no triangle?");
    const std::vector<Vec3> four = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    const Fixture drawn = fixture("corner on a side", four);
    const OnMesh on(drawn);
    CHECK(sorted(triangulate(four)) == Triangles{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("two corners are refused", "[points:1]") {
    hint("What is the least that a polygon must have?");
    const std::vector<Vec3> two = {{0, 0, 0}, {1, 0, 0}};
    CHECK_THROWS_AS(triangulate(two), std::invalid_argument);
}
