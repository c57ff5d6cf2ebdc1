// Hidden suite of intersect_sphere.
#include "exercises/06_geometry/intersect_sphere.h"

#include <cmath>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

/// A line whose distance from the center of the sphere is `d` radii, nearest
/// to it at the parameter `nearest`.
struct Passing {
    Line line;
    Sphere sphere;
    double nearest;
    double half;  ///< from there to the surface, in t

    /// The parameters that the extent has, by their definition.
    std::vector<double> within(Extent extent) const {
        std::vector<double> all;
        if (half > 0)
            all = {nearest - half, nearest + half};
        else if (half == 0)
            all = {nearest};
        std::vector<double> some;
        for (const double t : all)
            if (extent == Extent::line ||
                (t >= 0 && (extent == Extent::ray || t <= 1)))
                some.push_back(t);
        return some;
    }
};

Passing passing(const hidden::Placement& placement, double d, double nearest,
                double radius, double step, hidden::Chance& chance) {
    const Vec3 center = chance.point();
    const Vec3 along = chance.direction();
    const Vec3 q = center + d * radius * hidden::across(along, chance) -
                   nearest * step * along;
    const double half =
        d == 1 ? 0
               : (d > 1 ? -1 : radius * std::sqrt((1 - d) * (1 + d)) / step);
    return {{placement.point(q), placement.direction(step * along)},
            {placement.point(center), radius * placement.scale},
            nearest,
            half};
}

/// In all places, with directions of several lengths; no end of a segment is
/// near the surface.
std::vector<Passing> all_passing(double d, double nearest, std::uint64_t salt) {
    hidden::Chance chance(salt);
    std::vector<Passing> result;
    for (const hidden::Placement& placement : hidden::placements())
        for (const double step : {1.0, 0.2, 5.0}) {
            const double radius = chance.between(0.5, 2);
            const Passing one =
                passing(placement, d, nearest, radius, step, chance);
            const auto near_end = [](double t) {
                return std::abs(t) < 1e-4 || std::abs(t - 1) < 1e-4;
            };
            if (near_end(one.nearest - one.half) ||
                near_end(one.nearest + one.half))
                continue;
            result.push_back(one);
        }
    return result;
}

void check_parameters(const Line& line, const Sphere& sphere,
                      const std::vector<double>& expected, double size) {
    const std::vector<double> got = intersect_sphere(line, sphere);
    INFO("expected " << show(expected) << ", got " << show(got));
    REQUIRE(got.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK_THAT(got[k], IsAbout(expected[k], size));
}

void check_passing(const Passing& passing, Extent extent) {
    Line line = passing.line;
    line.extent = extent;
    check_parameters(line, passing.sphere, passing.within(extent),
                     1 + std::abs(passing.nearest) + std::abs(passing.half));
}

}  // namespace

TEST_CASE("lines through the sphere", "[points:3]") {
    hint("How far from the nearest point are the two, counted in t?");
    for (const double d : {0.0, 0.1, 0.5, 0.9, 0.999})
        for (const double nearest : {-3.0, -0.4, 0.0, 0.5, 2.0, 10.0})
            for (const Passing& passing : all_passing(d, nearest, 640))
                check_passing(passing, Extent::line);
}

TEST_CASE("rays that begin before, inside and behind", "[points:3]") {
    hint("How many of the two points of the line come after the beginning?");
    for (const double d : {0.0, 0.3, 0.8})
        for (const double nearest : {-6.0, -0.7, -0.01, 0.2, 3.0, 15.0})
            for (const Passing& passing : all_passing(d, nearest, 641))
                check_passing(passing, Extent::ray);
}

TEST_CASE("segments before, into, inside, out of and through", "[points:3]") {
    hint("Is a segment that is all inside on the surface anywhere?");
    for (const double d : {0.0, 0.3, 0.8})
        for (const double nearest : {-6.0, -0.7, 0.1, 0.5, 0.9, 1.6, 3.0})
            for (const Passing& passing : all_passing(d, nearest, 642))
                check_passing(passing, Extent::segment);
}

TEST_CASE("lines that pass by", "[points:1]") {
    hint("What is the distance of the line from the center?");
    for (const double d : {1.000001, 1.01, 1.5, 4.0})
        for (const double nearest : {-2.0, 0.5, 5.0})
            for (const Passing& passing : all_passing(d, nearest, 643))
                for (const Extent extent :
                     {Extent::line, Extent::ray, Extent::segment})
                    check_passing(passing, extent);
}

TEST_CASE("lines that touch, or nearly do", "[points:3]") {
    hint("When is the difference of two distances as good as 0?");
    for (const double nearest : {-2.0, 0.3, 0.7, 4.0})
        for (const double d : {1.0, 1 - 1e-6})
            for (const Passing& passing : all_passing(d, nearest, 644))
                for (const Extent extent :
                     {Extent::line, Extent::ray, Extent::segment})
                    check_passing(passing, extent);
    // Within the tolerance on either side.
    for (const double at : {1 + 5e-10, 1 - 5e-10, 1 + 1e-12, 1 - 1e-12})
        check_parameters({{-3, at, 0}, {2, 0, 0}}, {{0, 0, 0}, 1}, {1.5}, 3);
    // Just beyond it.
    const double y = 1 - 2e-9;
    const double half = std::sqrt((1 - y) * (1 + y)) / 2;
    check_parameters({{-3, y, 0}, {2, 0, 0}}, {{0, 0, 0}, 1},
                     {1.5 - half, 1.5 + half}, 3);
    check_parameters({{-3, 1 + 2e-9, 0}, {2, 0, 0}}, {{0, 0, 0}, 1}, {}, 3);
    for (const double r : {1e-3, 1e4})
        check_parameters({{-3 * r, r + 5e-10 * r, 0}, {2 * r, 0, 0}},
                         {{0, 0, 0}, r}, {1.5}, 3);
}

TEST_CASE("a sphere that is small or large beside u", "[points:1]") {
    hint("Does t count in lengths of u, whatever the radius is?");
    hidden::Chance chance(645);
    for (const hidden::Placement& placement : hidden::placements())
        for (const double radius : {0.05, 40.0})
            for (const double step : {0.01, 20.0})
                for (const double d : {0.3, 2.0})
                    check_passing(
                        passing(placement, d, 0.1, radius, step, chance),
                        Extent::line);
}

TEST_CASE("an end that is on the surface", "[points:1]") {
    hint("Do the ends of a segment belong to it?");
    const Sphere sphere{{8, 0, 0}, 4};
    const Extent ray = Extent::ray;
    const Extent segment = Extent::segment;
    check_parameters({{4, 0, 0}, {8, 0, 0}, segment}, sphere, {0, 1}, 1);
    check_parameters({{4, 0, 0}, {8, 0, 0}, ray}, sphere, {0, 1}, 1);
    check_parameters({{4, 0, 0}, {-8, 0, 0}, ray}, sphere, {0}, 1);
    check_parameters({{12, 0, 0}, {-4, 0, 0}, segment}, sphere, {0}, 1);
    check_parameters({{0, 0, 0}, {4, 0, 0}, segment}, sphere, {1}, 1);
    check_parameters({{8, 0, 0}, {4, 0, 0}, segment}, sphere, {1}, 1);
}
