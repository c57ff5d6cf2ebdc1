#include "exercises/05_structures/greedy_strip.h"

#include "course/halfedge/build.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

/// The half-edge that runs from vertex `from` to vertex `to`.
int half_edge(const Fixture& fixture, int from, int to) {
    const std::vector<HalfEdge>& rows = fixture.he.rows();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].vi == from &&
            rows[static_cast<std::size_t>(rows[i].opp)].vi == to)
            return static_cast<int>(i);
    return -1;
}

/// band: four triangles in a row                       0-----2-----4
//                                                       \ F0/ \ F2/ \.
//                                                        \ / F1\ / F3\.
//                                                         1-----3-----5
Fixture band() {
    const IndexedMesh mesh{{{0, 2}, {1, 0}, {2, 2}, {3, 0}, {4, 2}, {5, 0}},
                           {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}},
                           {}};
    return {"band of four triangles", mesh, build(mesh)};
}

}  // namespace

TEST_CASE("a band of four triangles, from both of its ends", "[points:1]") {
    hint("Which edge joins the last two vertices of the strip so far?");
    const Fixture mesh = band();
    const OnMesh on(mesh);
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 0, 1)) ==
          std::vector<int>{0, 1, 2, 3, 4, 5});
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 5, 4)) ==
          std::vector<int>{5, 4, 3, 2, 1, 0});
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 1, 2)) ==
          std::vector<int>{1, 2, 0});
}

TEST_CASE("all four triangles of the tetrahedron", "[points:1]") {
    hint("How do you notice that the strip has a triangle already?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    CHECK(greedy_strip(tetra.he, half_edge(tetra, 1, 2)) ==
          std::vector<int>{1, 2, 3, 0, 1, 2});
}

TEST_CASE("no strip begins outside the mesh", "[points:1]") {
    hint("Along which face does a half-edge on the border run?");
    const Fixture mesh = band();
    const OnMesh on(mesh);
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 1, 0)).empty());
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 2, 4)).empty());
    CHECK(greedy_strip(mesh.he, half_edge(mesh, 4, 2)) ==
          std::vector<int>{4, 2, 3, 1});
}
