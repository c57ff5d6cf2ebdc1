#include "exercises/08_making/voxel_surface.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

/// The volume inside the quads; below 0 when they look inwards.
double volume(const IndexedMesh& mesh) {
    double sum = 0;
    for (const FaceList::Face face : mesh.faces) {
        REQUIRE(face.size() == 4);
        for (const int v : face) REQUIRE((0 <= v && v < mesh.vertex_count()));
        const auto at = [&](std::size_t k) {
            return mesh.positions[static_cast<std::size_t>(face[k])];
        };
        sum += dot(at(0), cross(at(1) - at(0), at(3) - at(0))) / 3;
    }
    return sum;
}

}  // namespace

TEST_CASE("one full cell is a cube", "[points:1]") {
    hint("Seen from outside, which way round does each of the six sides run?");
    const IndexedMesh cube = voxel_surface({1, 1, 1, {true}});
    CHECK(cube.vertex_count() == 8);
    CHECK(cube.faces.size() == 6);
    const double inside = volume(cube);
    CHECK_THAT(inside, IsAbout(1));
}

TEST_CASE("two full cells side by side, and an empty one", "[points:1]") {
    hint("What is there between the two full cells?");
    const IndexedMesh both = voxel_surface({3, 1, 1, {false, true, true}});
    CHECK(both.vertex_count() == 12);
    CHECK(both.faces.size() == 10);
    const double inside = volume(both);
    CHECK_THAT(inside, IsAbout(2));
}

TEST_CASE("a list of another length is refused", "[points:1]") {
    hint("How many cells has the grid, and how many does the list have?");
    CHECK_THROWS_AS(voxel_surface({2, 2, 2, {true}}), std::invalid_argument);
}
