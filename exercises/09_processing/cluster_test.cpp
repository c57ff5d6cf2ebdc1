#include "exercises/09_processing/cluster.h"

#include <limits>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh in cubes of side 2", "[points:1]") {
    hint("In which cube does each vertex lie? -1 / 2 is below 0.");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const IndexedMesh got = cluster(slide.mesh, 2);
    CHECK_THAT(got.positions,
               AreAt({{0.5, 0.5}, {1.25, -1.5}, {2, 1}, {2, -1}}, 3));
    REQUIRE(got.faces.size() == 1);
    const std::vector<int> face(got.faces[0].begin(), got.faces[0].end());
    CHECK_THAT(face, IsRotationOf({0, 1, 3, 2}));
}

TEST_CASE("in small cubes nothing falls together", "[points:1]") {
    hint("What is the result when each vertex has a cube of its own?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    const IndexedMesh got = cluster(cube.mesh, 0.25);
    CHECK_THAT(got.positions, AreAt(cube.mesh.positions, 2));
    REQUIRE(got.faces.size() == 6);
    for (int f = 0; f < 6; ++f) {
        const FaceList::Face before = cube.mesh.faces[f];
        const std::vector<int> face(got.faces[f].begin(), got.faces[f].end());
        CHECK_THAT(face, IsRotationOf({before.begin(), before.end()}));
    }
}

TEST_CASE("one large cube leaves nothing", "[points:1]") {
    hint("Is a face with one corner a face? Who uses the vertex then?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    const IndexedMesh got = cluster(cube.mesh, 100);
    CHECK(got.faces.size() == 0);
    CHECK(got.positions.empty());
}

TEST_CASE("a cube must have a size", "[points:1]") {
    hint("For which `cell` is there no cube to put a vertex into?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(cluster(slide.mesh, 0), std::invalid_argument);
    CHECK_THROWS_AS(cluster(slide.mesh, -1), std::invalid_argument);
    CHECK_THROWS_AS(
        cluster(slide.mesh, std::numeric_limits<double>::infinity()),
        std::invalid_argument);
}
