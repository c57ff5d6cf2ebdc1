#include "exercises/06_geometry/intersect_sphere.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

const Sphere sphere{{0, 0, 0}, 1};

}  // namespace

TEST_CASE("through the unit sphere, past it, and touching", "[points:1]") {
    hint("How far from the center is the line, compared with the radius?");
    const auto two = intersect_sphere({{-3, 0, 0}, {2, 0, 0}}, sphere);
    REQUIRE(two.size() == 2);
    CHECK_THAT(two[0], IsAbout(1));
    CHECK_THAT(two[1], IsAbout(2));
    CHECK(intersect_sphere({{-3, 2, 0}, {2, 0, 0}}, sphere).empty());
    const auto touching = intersect_sphere({{-3, 1, 0}, {2, 0, 0}}, sphere);
    REQUIRE(touching.size() == 1);
    CHECK_THAT(touching[0], IsAbout(1.5));
}

TEST_CASE("rays and segments from the inside", "[points:1]") {
    hint("Which of the two t of the line belong to the ray?");
    const Line ray{{0, 0, 0}, {2, 0, 0}, Extent::ray};
    const auto one = intersect_sphere(ray, sphere);
    REQUIRE(one.size() == 1);
    CHECK_THAT(one[0], IsAbout(0.5));
    const Line inside{{0, 0, 0}, {0.5, 0, 0}, Extent::segment};
    CHECK(intersect_sphere(inside, sphere).empty());
}
