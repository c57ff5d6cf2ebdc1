#include "exercises/02_border/with_dangling_edge.h"

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
    } while (i != start && 0 <= i && i < he.size() && walked.size() < 20);
    return walked;
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
