// Hidden suite of intersect_plane.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

/// A line and a plane that meet at a parameter that is chosen beforehand.
struct Meeting {
    Line line;
    Plane plane;
};

/// They meet at t; directions and normals of all lengths.
std::vector<Meeting> meetings(double t, std::uint64_t salt) {
    hidden::Chance chance(salt);
    std::vector<Meeting> result;
    for (const hidden::Placement& placement : hidden::placements())
        for (const double stretch : {1.0, 0.01, 300.0}) {
            const Vec3 q = chance.point();
            const Vec3 u = chance.between(0.3, 3) * chance.direction();
            Vec3 normal = chance.direction();
            while (std::abs(dot(normal, u)) < 0.1 * length(u))
                normal = chance.direction();
            const Vec3 there = q + t * u;
            const Vec3 aside =
                chance.between(-3, 3) * hidden::across(normal, chance);
            result.push_back(
                {{placement.point(q), placement.direction(u)},
                 {placement.point(there + aside),
                  (stretch / placement.scale) * placement.direction(normal)}});
        }
    return result;
}

std::optional<double> asked(Meeting meeting, Extent extent) {
    meeting.line.extent = extent;
    return intersect_plane(meeting.line, meeting.plane);
}

void check_meets(const Meeting& meeting, Extent extent, double t) {
    const std::optional<double> got = asked(meeting, extent);
    REQUIRE(got.has_value());
    CHECK_THAT(*got, IsAbout(t, 1));
}

}  // namespace

TEST_CASE("a line meets a plane at a point of both", "[points:3]") {
    hint("Is q + t * u, with your t, a point of the plane?");
    for (const double t : {-40.0, -1.0, -0.1, 0.0, 0.3, 1.0, 2.5, 40.0})
        for (const Meeting& meeting : meetings(t, 630))
            check_meets(meeting, Extent::line, t);
}

TEST_CASE("a ray meets what is before it", "[points:2]") {
    hint("Which t has a ray, and does it have an end?");
    for (const double t : {1e-6, 0.1, 1.0, 1.5, 40.0})
        for (const Meeting& meeting : meetings(t, 631))
            check_meets(meeting, Extent::ray, t);
    for (const double t : {-1e-6, -0.1, -1.0, -40.0})
        for (const Meeting& meeting : meetings(t, 632))
            CHECK_FALSE(asked(meeting, Extent::ray).has_value());
}

TEST_CASE("a segment meets what is between its ends", "[points:2]") {
    hint("What are the t of the two ends?");
    for (const double t : {1e-6, 0.1, 0.5, 0.9, 1 - 1e-6})
        for (const Meeting& meeting : meetings(t, 633))
            check_meets(meeting, Extent::segment, t);
    for (const double t : {-40.0, -1e-6, 1 + 1e-6, 1.5, 40.0})
        for (const Meeting& meeting : meetings(t, 634))
            CHECK_FALSE(asked(meeting, Extent::segment).has_value());
}

TEST_CASE("an end that is in the plane", "[points:1]") {
    hint("Do the ends of a segment belong to it?");
    const Plane plane{{3, -7, 2}, {0, 0, 4}};
    for (const Extent extent : {Extent::line, Extent::ray, Extent::segment}) {
        check_meets({{{1, 1, 2}, {0, 0, 8}}, plane}, extent, 0);
        check_meets({{{1, 1, 2}, {0, 0, -8}}, plane}, extent, 0);
        check_meets({{{1, 1, -6}, {0, 0, 8}}, plane}, extent, 1);
        check_meets({{{1, 1, 10}, {0, 0, -8}}, plane}, extent, 1);
    }
}

TEST_CASE("parallel lines, beside the plane and in it", "[points:2]") {
    hint("Does what you compare with 1e-12 depend on lengths?");
    hidden::Chance chance(635);
    for (const hidden::Placement& placement : hidden::placements())
        for (const double stretch : {1.0, 1e-4, 1e4}) {
            const Vec3 q = chance.point();
            const Vec3 normal = chance.direction();
            const Vec3 u =
                chance.between(0.3, 3) * hidden::across(normal, chance);
            for (const double height : {0.0, 0.5, -2.0})
                for (const Extent extent :
                     {Extent::line, Extent::ray, Extent::segment}) {
                    const Line line{placement.point(q + height * normal),
                                    placement.direction(stretch * u), extent};
                    const Plane plane{placement.point(q),
                                      stretch * placement.direction(normal)};
                    CHECK_FALSE(intersect_plane(line, plane).has_value());
                }
        }
}

TEST_CASE("nearly parallel is not parallel", "[points:2]") {
    hint("Where is the limit: is a small scalar product a small cosine?");
    const Plane plane{{0, 0, 0}, {0, 0, 1}};
    check_meets({{{0, 0, 1}, {1, 0, -0x1p-30}}, plane}, Extent::ray, 0x1p30);
    check_meets({{{0, 0, 1}, {0, 1, 0x1p-36}}, plane}, Extent::line, -0x1p36);
    check_meets({{{0, 0, 1}, {0, 1, 0x1p-39}}, plane}, Extent::line, -0x1p39);
    for (const double z : {0x1p-41, -0x1p-41, 1e-13, 0.0})
        CHECK_FALSE(intersect_plane({{0, 0, 1}, {0, 1, z}}, plane).has_value());
    // Short directions and normals, at a right angle to the plane.
    for (const double small : {1e-5, 1e-7, 1e-9})
        for (const double normal : {1e-9, 1e-6, 1e6})
            check_meets({{{0, 0, 3 * small}, {0, 0, -small}},
                         {{5, 5, 0}, {0, 0, normal}}},
                        Extent::line, 3);
    CHECK_FALSE(intersect_plane({{0, 0, 1}, {1, 0, 1e-13}}, plane).has_value());
    CHECK_FALSE(
        intersect_plane({{0, 0, 1}, {1e9, 0, 1e-5}}, plane).has_value());
    CHECK_FALSE(intersect_plane({{0, 0, 0}, {1, 0, 1e-13}}, plane).has_value());
}
