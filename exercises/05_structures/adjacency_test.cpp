#include "exercises/05_structures/adjacency.h"

#include <algorithm>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The ends of edge e, the smaller first; {-1, -1} if there is no edge e.
std::vector<int> ends(const Adjacency& lists, int e) {
    if (e < 0 || e >= static_cast<int>(lists.edges.size())) return {-1, -1};
    auto [a, b] = lists.edges[static_cast<std::size_t>(e)].vertices;
    return {std::min(a, b), std::max(a, b)};
}

std::vector<std::vector<int>> all_ends(const Adjacency& lists,
                                       const std::vector<int>& edges) {
    std::vector<std::vector<int>> all;
    for (const int e : edges) all.push_back(ends(lists, e));
    return all;
}

}  // namespace

TEST_CASE("the corners and edges of the faces of the slide mesh",
          "[points:1]") {
    hint("Which two corners does edge number i of a face join?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Adjacency lists = adjacency(slide.mesh);
    CHECK(lists.edges.size() == 8);
    REQUIRE(lists.faces.size() == 3);
    CHECK(lists.faces[1].vertices == std::vector<int>{1, 2, 5, 4});
    CHECK(all_ends(lists, lists.faces[0].edges) ==
          std::vector<std::vector<int>>{{0, 2}, {1, 2}, {0, 1}});
    CHECK(all_ends(lists, lists.faces[1].edges) ==
          std::vector<std::vector<int>>{{1, 2}, {2, 5}, {4, 5}, {1, 4}});
}

TEST_CASE("the edges and faces at vertices of the slide mesh", "[points:1]") {
    hint("Who must learn about a new edge, and who about each face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Adjacency lists = adjacency(slide.mesh);
    REQUIRE(lists.vertices.size() == 6);
    CHECK_THAT(lists.vertices[2].faces, IsPermutationOf({0, 1, 2}));
    CHECK_THAT(lists.vertices[3].faces, IsPermutationOf({2}));
    auto at_2 = all_ends(lists, lists.vertices[2].edges);
    std::sort(at_2.begin(), at_2.end());
    CHECK(at_2 ==
          std::vector<std::vector<int>>{{0, 2}, {1, 2}, {2, 3}, {2, 5}});
}

TEST_CASE("the faces at the edges of the slide mesh", "[points:1]") {
    hint("How many faces have the edge between 1 and 2? Between 0 and 1?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Adjacency lists = adjacency(slide.mesh);
    REQUIRE(lists.edges.size() == 8);
    for (int e = 0; e < 8; ++e) {
        const auto& faces = lists.edges[static_cast<std::size_t>(e)].faces;
        if (ends(lists, e) == std::vector<int>{1, 2})
            CHECK_THAT(faces, IsPermutationOf({0, 1}));
        if (ends(lists, e) == std::vector<int>{0, 1})
            CHECK_THAT(faces, IsPermutationOf({0}));
    }
}
