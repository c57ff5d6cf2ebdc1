#include "exercises/01_traversal/valences.h"

#include "course/runner/by_faces.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("valences of the slide mesh", "[points:2]") {
    hint(
        "How many rows of the table have vi = 2, and how many edges are at "
        "vertex 2?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(valences(slide.he, 6) == std::map<int, int>{{2, 3}, {3, 2}, {4, 1}});
}

TEST_CASE("a vertex without an edge has valence 0", "[points:1]") {
    hint("Does a vertex that is in no row of the table exist?");
    Fixture slide = zoo::slide();
    slide.mesh.positions.push_back({3, 2});
    slide.mesh.positions.push_back({3, 1});
    const OnMesh on(slide);
    CHECK(valences(slide.he, 8) ==
          std::map<int, int>{{0, 2}, {2, 3}, {3, 2}, {4, 1}});
}

TEST_CASE("valences of generated meshes", "[points:1]") {
    hint("Do you reach every edge of every vertex, and each of them once?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        REQUIRE(valences(mesh.he, mesh.mesh.vertex_count()) ==
                oracle::ByFaces(mesh).valences());
    });
}
