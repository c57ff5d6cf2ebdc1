#include "exercises/08_making/marching_cubes.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("one corner of one cell is inside", "[points:1]") {
    hint("Which three edges are crossed, and after which part of each?");
    const IndexedMesh mesh =
        marching_cubes({2, 2, 2, {4, 0, 0, 0, 0, 0, 0, 0}}, 1);
    REQUIRE(mesh.vertex_count() == 3);
    REQUIRE(mesh.faces.size() == 1);
    REQUIRE(mesh.faces[0].size() == 3);
    std::vector<Vec3> corners;
    for (const int v : mesh.faces[0]) {
        REQUIRE((0 <= v && v < 3));
        corners.push_back(mesh.positions[static_cast<std::size_t>(v)]);
    }
    std::rotate(corners.begin(),
                std::max_element(corners.begin(), corners.end(),
                                 [](Vec3 a, Vec3 b) { return a.x < b.x; }),
                corners.end());
    CHECK_THAT(corners, AreAt({{0.75, 0, 0}, {0, 0.75, 0}, {0, 0, 0.75}}, 1));
}

TEST_CASE("a single point in the middle is inside", "[points:1]") {
    hint("How many edges end at that point, and how many cells meet there?");
    DensityGrid grid{3, 3, 3, std::vector<double>(27, -1)};
    grid.density[13] = 1;
    const IndexedMesh mesh = marching_cubes(grid, 0);
    CHECK(mesh.vertex_count() == 6);
    CHECK(mesh.faces.size() == 8);
}

TEST_CASE("a list of another length is refused", "[points:1]") {
    hint("How many points has the grid, and how many densities are there?");
    CHECK_THROWS_AS(marching_cubes({2, 2, 2, {1, 2, 3}}, 0),
                    std::invalid_argument);
}
