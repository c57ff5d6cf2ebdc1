#include "exercises/02_border/with_dangling_edge.h"

#include <algorithm>

#include "course/runner/border_by_faces.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

/// The half-edges from i on, by next; cut short when that does not come back.
std::vector<int> walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walked;
    const int start = i;
    do {
        walked.push_back(i);
        i = he[i].next;
    } while (i != start && 0 <= i && i < he.size() &&
             static_cast<int>(walked.size()) < he.size());
    return walked;
}

/// Hangs an edge behind the first half-edge of a border loop.
void check_first_of(std::vector<int> loop, const Fixture& mesh) {
    const int new_vertex = mesh.mesh.vertex_count();
    const int old_size = mesh.he.size();
    const HalfEdgeTable he = with_dangling_edge(mesh.he, loop[0], new_vertex);
    REQUIRE(he.size() == old_size + 2);
    const int out = he[loop[0]].next;
    REQUIRE((out == old_size || out == old_size + 1));
    const int back = old_size + old_size + 1 - out;
    CHECK(he[out] == HalfEdge{mesh.he[loop[1]].vi, -1, back, back});
    CHECK(he[back] == HalfEdge{new_vertex, -1, loop[1], out});
    loop.insert(loop.begin() + 1, {out, back});
    CHECK(walk(he, loop[0]) == loop);
}

}  // namespace

TEST_CASE("vertex 6 hangs on vertex 4 of the slide mesh", "[points:1]") {
    hint("Two half-edges are new. Which fields of the old ones must know?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = with_dangling_edge(slide.he, 6, 6);
    REQUIRE(he.size() == 18);
    const int out = he[6].next;
    REQUIRE((out == 16 || out == 17));
    const int back = 16 + 17 - out;
    CHECK(he[out] == HalfEdge{4, -1, back, back});
    CHECK(he[back] == HalfEdge{6, -1, 7, out});
}

TEST_CASE("the border walk is longer by two, the faces are as before",
          "[points:1]") {
    hint("Where must the walk go after the way back from the new vertex?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = with_dangling_edge(slide.he, 6, 6);
    REQUIRE(he.size() == 18);
    CHECK(walk(he, 0).size() == 8);
    CHECK(walk(he, 1) == std::vector<int>{1, 3, 5});
    CHECK(walk(he, 4) == std::vector<int>{4, 11, 15, 12});
    CHECK(walk(he, 8) == std::vector<int>{8, 14, 9});
}

TEST_CASE("half-edges along a face and numbers off the table are refused",
          "[points:1]") {
    hint("What must be known about `border` before the table is changed?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(with_dangling_edge(slide.he, 12, 6), std::invalid_argument);
    CHECK_THROWS_AS(with_dangling_edge(slide.he, -1, 6), std::invalid_argument);
    CHECK_THROWS_AS(with_dangling_edge(slide.he, 16, 6), std::invalid_argument);
}

TEST_CASE("an edge at each border corner, on generated meshes", "[points:1]") {
    hint("Where does the walk go from `border`, and after it has come back?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        const oracle::Border border(mesh);
        for (std::vector<int> loop : border.loops())
            for (std::size_t k = 0; k < loop.size(); ++k) {
                check_first_of(loop, mesh);
                std::rotate(loop.begin(), loop.begin() + 1, loop.end());
            }
    });
}
