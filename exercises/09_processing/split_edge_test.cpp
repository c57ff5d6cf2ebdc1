#include "exercises/09_processing/split_edge.h"

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a border edge of the slide mesh", "[points:1]") {
    hint("F0 is cut in two. Which half keeps its number, and what is new?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = split_edge(slide.he, 1, 6);
    REQUIRE(he.size() == 20);
    REQUIRE(validate(he).empty());
    std::vector<std::vector<int>> corners(3);
    for (const HalfEdge& row : he.rows())
        if (0 <= row.fi && row.fi < 3)
            corners[static_cast<std::size_t>(row.fi)].push_back(row.vi);
    CHECK_THAT(corners[0], IsPermutationOf({0, 6, 1}));
    CHECK_THAT(corners[1], IsPermutationOf({1, 2, 5, 4}));
    CHECK_THAT(corners[2], IsPermutationOf({2, 3, 5}));
}

TEST_CASE("an edge between two triangles of a tetrahedron", "[points:1]") {
    hint("Both triangles are cut. Do you count three edges more?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    const HalfEdgeTable he = split_edge(tetra.he, 0, 4);
    REQUIRE(he.size() == 18);
    REQUIRE(validate(he).empty());
    int at_new = 0;
    for (const HalfEdge& row : he.rows()) {
        CHECK(row.fi != -1);
        at_new += row.vi == 4 ? 1 : 0;
    }
    CHECK(at_new == 4);
}

TEST_CASE("along a quad, and with a vertex that is there already",
          "[points:1]") {
    hint("Which faces can be cut this way, and which vertex numbers are free?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(split_edge(slide.he, 3, 6), std::invalid_argument);
    CHECK_THROWS_AS(split_edge(slide.he, 1, 5), std::invalid_argument);
    CHECK_THROWS_AS(split_edge(slide.he, 16, 6), std::invalid_argument);
}
