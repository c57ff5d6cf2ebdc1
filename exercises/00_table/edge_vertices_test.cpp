#include "exercises/00_table/edge_vertices.h"

#include "course/runner/suite.h"

using namespace course;

using Ends = std::array<int, 2>;

TEST_CASE("edges of the slide mesh have the ends that the table says",
          "[points:2]") {
    hint("Which half-edge of the same edge leaves the other end?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_vertices(slide.he, 12) == Ends{4, 1});
    CHECK(edge_vertices(slide.he, 8) == Ends{5, 2});
    CHECK(edge_vertices(slide.he, 3) == Ends{2, 1});
}

TEST_CASE("a half-edge on the border has two ends as well", "[points:1]") {
    hint(
        "Which field do you read on the way, and does it exist on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_vertices(slide.he, 0) == Ends{2, 0});
    CHECK(edge_vertices(slide.he, 7) == Ends{4, 5});
}
