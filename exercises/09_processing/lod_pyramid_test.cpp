#include "exercises/09_processing/lod_pyramid.h"

#include "course/runner/geometry.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh has two levels", "[points:1]") {
    hint("What is asked of simplify for level 1, and for level 2?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const std::vector<LevelOfDetail> pyramid =
        lod_pyramid(slide.he, slide.mesh.positions, 9);
    REQUIRE(pyramid.size() == 2);
    CHECK_THAT(pyramid[0].he, IsTableOf(slide.mesh));
    CHECK_THAT(pyramid[1].he,
               IsTableOf({slide.mesh.positions, {{0, 2, 1}}, {}}));
}

TEST_CASE("from which distance on a level may be used", "[points:1]") {
    hint("How long are the edges of each level, on average?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const std::vector<LevelOfDetail> pyramid =
        lod_pyramid(slide.he, slide.mesh.positions, 2);
    REQUIRE(pyramid.size() == 2);
    const double fine = 2 * std::sqrt(2) + 2 + 2 + 2 * std::sqrt(1.25) + 1 + 1;
    const double coarse = 2 * std::sqrt(2) + 2;
    CHECK_THAT(pyramid[0].from, IsAbout(1));
    CHECK_THAT(pyramid[1].from, IsAbout((coarse / 3) / (fine / 8)));
}

TEST_CASE("a pyramid of one level, and of none", "[points:1]") {
    hint("How many levels are there before the first collapse?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(lod_pyramid(slide.he, slide.mesh.positions, 1).size() == 1);
    CHECK_THROWS_AS(lod_pyramid(slide.he, slide.mesh.positions, 0),
                    std::invalid_argument);
}
