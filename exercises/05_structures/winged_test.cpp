#include "exercises/05_structures/winged.h"

#include <algorithm>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The two ends of edge e, the smaller first; {-1, -1} if there is no edge e.
std::vector<int> ends(const WingedMesh& mesh, int e) {
    if (e < 0 || e >= static_cast<int>(mesh.edges.size())) return {-1, -1};
    const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
    return {std::min(edge.from, edge.to), std::max(edge.from, edge.to)};
}

/// The edge between 1 and 2, read from 1 to 2 whichever way it is stored.
WingedEdge from_1_to_2(const WingedMesh& mesh) {
    for (const WingedEdge& e : mesh.edges) {
        if (e.from == 1 && e.to == 2) return e;
        if (e.from == 2 && e.to == 1)
            return {e.to,       e.from,    e.right,      e.left,
                    e.to_right, e.to_left, e.from_right, e.from_left};
    }
    return {};
}

}  // namespace

TEST_CASE("the slide mesh has eight edges", "[points:1]") {
    hint("Which two half-edges make one edge?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const WingedMesh mesh = winged(slide.he);
    std::vector<std::vector<int>> edges;
    for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e)
        edges.push_back(ends(mesh, e));
    std::sort(edges.begin(), edges.end());
    CHECK(edges ==
          std::vector<std::vector<int>>{
              {0, 1}, {0, 2}, {1, 2}, {1, 4}, {2, 3}, {2, 5}, {3, 5}, {4, 5}});
}

TEST_CASE("the eight references of the edge between 1 and 2", "[points:1]") {
    hint("What comes before and after half-edges 4 and 3, and at which end?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const WingedMesh mesh = winged(slide.he);
    const WingedEdge edge = from_1_to_2(mesh);
    CHECK(edge.left == 1);
    CHECK(edge.right == 0);
    CHECK(ends(mesh, edge.from_left) == std::vector<int>{1, 4});
    CHECK(ends(mesh, edge.to_left) == std::vector<int>{2, 5});
    CHECK(ends(mesh, edge.from_right) == std::vector<int>{0, 1});
    CHECK(ends(mesh, edge.to_right) == std::vector<int>{0, 2});
}

TEST_CASE("an edge for each vertex and each face", "[points:1]") {
    hint("Which edge may stand for a vertex, and which for a face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const WingedMesh mesh = winged(slide.he);
    REQUIRE(mesh.vertex.size() == 6);
    REQUIRE(mesh.face.size() == 3);
    for (int v = 0; v < 6; ++v) {
        const std::vector<int> at =
            ends(mesh, mesh.vertex[static_cast<std::size_t>(v)]);
        CHECK((at[0] == v || at[1] == v));
    }
}
