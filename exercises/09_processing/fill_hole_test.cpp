#include "exercises/09_processing/fill_hole.h"

#include <map>

#include "course/halfedge/validate.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the border of the slide mesh is closed", "[points:1]") {
    hint("Which three half-edges does the triangle on half-edge 0 have?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const HalfEdgeTable he = fill_hole(slide.he, 0, 6);
    REQUIRE(he.size() == 28);
    REQUIRE(validate(he).empty());
    std::map<int, std::vector<int>> corners;
    for (const HalfEdge& row : he.rows()) corners[row.fi].push_back(row.vi);
    CHECK(corners.size() == 9);
    CHECK(corners.count(-1) == 0);
    CHECK_THAT(corners[1], IsPermutationOf({1, 2, 5, 4}));
    for (const auto& [face, vertices] : corners)
        if (face > 2) CHECK(vertices.size() == 3);
}

TEST_CASE("one of the two holes of a ring", "[points:1]") {
    hint("Does your walk meet the loop of `border`, and no other half-edge?");
    const Fixture annulus = zoo::annulus();
    const OnMesh on(annulus);
    int border = 0;
    while (annulus.he.rows()[std::size_t(border)].fi != -1) ++border;
    const HalfEdgeTable he = fill_hole(annulus.he, border, 6);
    CHECK(he.size() == annulus.he.size() + 6);
    CHECK(validate(he).empty());
}

TEST_CASE("a face is no hole, and a vertex in use is not new", "[points:1]") {
    hint("What must be known about `border`, and about new_vertex?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(fill_hole(slide.he, 1, 6), std::invalid_argument);
    CHECK_THROWS_AS(fill_hole(slide.he, 16, 6), std::invalid_argument);
    CHECK_THROWS_AS(fill_hole(slide.he, 0, 3), std::invalid_argument);
}
