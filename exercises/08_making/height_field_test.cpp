#include "exercises/08_making/height_field.h"

#include <cmath>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// Each triangle begun at its smallest corner, the triangles in order.
std::vector<std::vector<int>> sorted(const FaceList& faces) {
    std::vector<std::vector<int>> all;
    for (const FaceList::Face face : faces) {
        all.emplace_back(face.begin(), face.end());
        std::rotate(all.back().begin(),
                    std::min_element(all.back().begin(), all.back().end()),
                    all.back().end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("a cell with a hole at one corner", "[points:1]") {
    hint("Which vertices are there, and what is the number of each?");
    const IndexedMesh mesh = height_field({2, 2, {5, 6, NAN, 8}});
    CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 5}, {1, 0, 6}, {1, 1, 8}});
    CHECK(sorted(mesh.faces) == std::vector<std::vector<int>>{{0, 1, 2}});
}

TEST_CASE("two full cells in a row", "[points:1]") {
    hint("How many triangles has a full cell? Where is point (i, j) in z?");
    const IndexedMesh mesh = height_field({3, 2, {0, 1, 2, 3, 4, 5}});
    CHECK(
        mesh.positions ==
        std::vector<Vec3>{
            {0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {0, 1, 3}, {1, 1, 4}, {2, 1, 5}});
    const auto faces = sorted(mesh.faces);
    REQUIRE(faces.size() == 4);
    for (const auto& corners : faces) CHECK(corners.size() == 3);
}

TEST_CASE("a list of another length than nx * ny is refused", "[points:1]") {
    hint("What must be known about z before it is read?");
    CHECK_THROWS_AS(height_field({2, 2, {1, 2, 3}}), std::invalid_argument);
}
