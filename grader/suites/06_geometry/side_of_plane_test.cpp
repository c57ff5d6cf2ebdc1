// Hidden suite of side_of_plane.
#include "exercises/06_geometry/side_of_plane.h"

#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

/// A plane in some place, and points at known distances from it.
struct Placed {
    hidden::Placement placement;
    Vec3 q, normal;
    double stretch;  ///< length of the normal that is asked with

    Plane plane() const {
        return {placement.point(q),
                (stretch / placement.scale) * placement.direction(normal)};
    }
    /// A point at `height` above the plane, in units of the placement.
    Vec3 above(double height, hidden::Chance& chance) const {
        return placement.point(
            q + chance.between(-2, 2) * hidden::across(normal, chance) +
            height * normal);
    }
};

std::vector<Placed> planes(std::uint64_t salt) {
    hidden::Chance chance(salt);
    std::vector<Placed> result;
    for (const hidden::Placement& placement : hidden::placements())
        for (const double stretch : {1.0, 1e-3, 25.0, 1e4})
            result.push_back(
                {placement, chance.point(), chance.direction(), stretch});
    return result;
}

}  // namespace

TEST_CASE("clearly on one side", "[points:2]") {
    hint("Which point of the plane do you start from, and which way is +?");
    hidden::Chance chance(620);
    for (const Placed& placed : planes(621)) {
        const double tolerance = 1e-6 * placed.placement.scale;
        for (const double height : {1e-3, 0.1, 1.0, 3.0, 50.0}) {
            CHECK(side_of_plane(placed.plane(), placed.above(height, chance),
                                tolerance) == Side::positive);
            CHECK(side_of_plane(placed.plane(), placed.above(-height, chance),
                                tolerance) == Side::negative);
        }
    }
}

TEST_CASE("on the plane, far from the point that is given", "[points:2]") {
    hint("Does the distance from the plane depend on where its q lies?");
    hidden::Chance chance(622);
    for (const Placed& placed : planes(623)) {
        const double tolerance = 1e-6 * placed.placement.scale;
        for (const double height : {0.0, 1e-8, -1e-8, 5e-7, -5e-7})
            CHECK(side_of_plane(placed.plane(), placed.above(height, chance),
                                tolerance) == Side::on);
        CHECK(side_of_plane(placed.plane(), placed.plane().q, tolerance) ==
              Side::on);
    }
}

TEST_CASE("just within the tolerance and just beyond it", "[points:3]") {
    hint("Is what you compare with the tolerance a distance?");
    hidden::Chance chance(624);
    for (const Placed& placed : planes(625))
        for (const double tolerance : {1e-4, 0.02, 0.5, 3.0}) {
            const double thick = tolerance * placed.placement.scale;
            const auto side = [&](double height) {
                return side_of_plane(placed.plane(),
                                     placed.above(height, chance), thick);
            };
            CHECK(side(0.99 * tolerance) == Side::on);
            CHECK(side(-0.99 * tolerance) == Side::on);
            CHECK(side(1.01 * tolerance) == Side::positive);
            CHECK(side(-1.01 * tolerance) == Side::negative);
        }
}

TEST_CASE("the plane z = 0 and others along the axes", "[points:1]") {
    hint("Which coordinates matter when the normal is along an axis?");
    const Plane planes[] = {{{0, 0, 0}, {0, 0, 2}},
                            {{0, 0, 0}, {0, 3, 0}},
                            {{0, 0, 0}, {0.25, 0, 0}}};
    const Vec3 up[] = {{7, -9, 1}, {-8, 1, 5}, {1, 6, -7}};
    for (int k = 0; k < 3; ++k) {
        CHECK(side_of_plane(planes[k], up[k], 0.5) == Side::positive);
        CHECK(side_of_plane(planes[k], -1 * up[k], 0.5) == Side::negative);
        CHECK(side_of_plane(planes[k], up[k], 1.5) == Side::on);
        CHECK(side_of_plane(planes[k], -1 * up[k], 1.5) == Side::on);
    }
}
