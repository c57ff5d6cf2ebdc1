#include "exercises/06_geometry/vertex_normals.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh is flat", "[points:1]") {
    hint("Does every vertex get its normal, and each of unit length?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(vertex_normals(slide.mesh),
               AreDirections(std::vector<Vec3>(6, Vec3{0, 0, 1})));
}

TEST_CASE("the lecture's tetrahedron is inside out", "[points:1]") {
    hint("Which face adds what, and at which vertices?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    CHECK_THAT(
        vertex_normals(tetra.mesh),
        AreDirections({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}));
}

TEST_CASE("a vertex without faces gets the zero vector", "[points:1]") {
    hint("What happens when you divide by the length of a sum of nothing?");
    Fixture triangle = zoo::triangle();
    triangle.mesh.positions.push_back({7, 7, 7});
    const OnMesh on(triangle);
    CHECK_THAT(vertex_normals(triangle.mesh),
               AreDirections({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {}}));
}
