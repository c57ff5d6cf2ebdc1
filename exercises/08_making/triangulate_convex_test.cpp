#include "exercises/08_making/triangulate_convex.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

/// Each triangle begun at its smallest corner: which one comes first is free.
FaceList from_the_smallest(const FaceList& faces) {
    FaceList begun;
    for (const FaceList::Face face : faces) {
        std::vector<int> corners(face.begin(), face.end());
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
        begun.push_back(corners);
    }
    return begun;
}

}  // namespace

TEST_CASE("the quad of the slide mesh becomes two triangles", "[points:1]") {
    hint("Which corner do the two triangles of the quad (1,2,5,4) begin at?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const IndexedMesh cut = triangulate_convex(slide.mesh);
    CHECK(from_the_smallest(cut.faces) ==
          FaceList{{0, 2, 1}, {1, 2, 5}, {1, 5, 4}, {2, 3, 5}});
    CHECK(cut.positions == slide.mesh.positions);
}

TEST_CASE("a face of two corners is refused", "[points:1]") {
    hint("What does your formula give for a face with two corners?");
    IndexedMesh mesh = zoo::slide().mesh;
    mesh.faces.push_back({4, 5});
    CHECK_THROWS_AS(triangulate_convex(mesh), std::invalid_argument);
}
