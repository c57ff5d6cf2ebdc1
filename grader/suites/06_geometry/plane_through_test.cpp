// Hidden suite of plane_through.
#include "exercises/06_geometry/plane_through.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

void check_plane(Vec3 p, Vec3 q, Vec3 r, Vec3 normal) {
    const std::optional<Plane> got = plane_through(p, q, r);
    REQUIRE(got.has_value());
    CHECK_THAT(got->u, IsDirection(normal));
    CHECK((got->q == p || got->q == q || got->q == r));
}

/// The plane of p, q, r in all orders: half of them turn the normal round.
void check_orders(Vec3 p, Vec3 q, Vec3 r, Vec3 normal) {
    check_plane(p, q, r, normal);
    check_plane(q, r, p, normal);
    check_plane(r, p, q, normal);
    check_plane(q, p, r, -1 * normal);
    check_plane(p, r, q, -1 * normal);
    check_plane(r, q, p, -1 * normal);
}

void check_none(Vec3 p, Vec3 q, Vec3 r) {
    CHECK_FALSE(plane_through(p, q, r).has_value());
    CHECK_FALSE(plane_through(q, r, p).has_value());
    CHECK_FALSE(plane_through(r, p, q).has_value());
    CHECK_FALSE(plane_through(r, q, p).has_value());
}

}  // namespace

TEST_CASE("triangles whose plane is known", "[points:2]") {
    hint("Is the normal at right angles to all three sides, and of length 1?");
    check_orders({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    check_orders({0, 0, 0}, {0, 3, 0}, {0, 0, 0.5}, {1, 0, 0});
    check_orders({7, 7, 7}, {7, 7, 9}, {12, 7, 7}, {0, 1, 0});
    check_orders({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 1});
    check_orders({6, 0, 0}, {0, 3, 0}, {0, 0, 2}, {1, 2, 3});
    check_orders({-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1});
}

TEST_CASE("triangles in all places, turned and scaled", "[points:3]") {
    hint("Does anything depend on where the points are, or on their unit?");
    hidden::Chance chance(610);
    for (const hidden::Placement& placement : hidden::placements())
        for (int k = 0; k < 6; ++k) {
            const Vec3 normal = chance.direction();
            const Vec3 a = hidden::across(normal, chance);
            const Vec3 b = cross(normal, a);
            const Vec3 p = chance.point();
            const double s = chance.between(0.2, 3);
            const Vec3 q = p + s * a;
            const Vec3 r =
                p + chance.between(-2, 2) * a + chance.between(0.1, 2) * b;
            check_orders(placement.point(p), placement.point(q),
                         placement.point(r), placement.direction(normal));
        }
}

TEST_CASE("very small and very large triangles", "[points:2]") {
    hint("Is what you compare the area with of the same kind, an area?");
    for (const double size : {1e-9, 1e-7, 1e-4, 1e5, 1e9})
        check_orders(size * Vec3{1, 0, 0}, size * Vec3{0, 1, 0},
                     size * Vec3{0, 0, 1}, {1, 1, 1});
    for (const double size : {1e-9, 1e-4, 1.0, 1e5, 1e9})
        check_none(size * Vec3{1, 0, 0}, size * Vec3{2, 1e-14, 0},
                   size * Vec3{4, 0, 0});
}

TEST_CASE("thin triangles are triangles", "[points:1]") {
    hint("Thin is not the same as on a line: where is the limit?");
    check_orders({0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}, {0, 0, 1});
    check_orders({0, 0, 0}, {1, 0, 0}, {0, 0, 1e-10}, {0, -1, 0});
    check_orders({0, 0, 0}, {1e-6, 0, 0}, {0, 1e3, 0}, {0, 0, 1});
}

TEST_CASE("points on a line, in any direction and order", "[points:2]") {
    hint("Rounding leaves a little area: how little counts as none?");
    hidden::Chance chance(611);
    for (const hidden::Placement& placement : hidden::placements())
        for (int k = 0; k < 4; ++k) {
            const Vec3 p = chance.point();
            const Vec3 u = chance.direction();
            const double length = placement.scale;
            const Vec3 far = (1 / length) * placement.shift;
            if (dot(far, far) > 1000) continue;
            check_none(placement.point(p), placement.point(p + u),
                       placement.point(p + chance.between(2, 3) * u));
            check_none(placement.point(p), placement.point(p + 2 * u),
                       placement.point(p));
        }
    check_none({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    check_none({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    check_none({0, 0, 0}, {1, 0, 0}, {0.5, 1e-14, 0});
}

TEST_CASE("the longest side decides what is thin", "[points:1]") {
    hint("Which of the three sides is the longest, in each order of points?");
    // Two sides of length 1 and one of 2: half the limit, and twice as much.
    for (const double size : {1.0, 0x1p-12, 0x1p20}) {
        const Vec3 left = size * Vec3{4, 0, 5};
        const Vec3 right = size * Vec3{6, 0, 5};
        const Vec3 middle = size * Vec3{5, 1e-12, 5};
        check_none(left, middle, right);
        check_none(left, right, middle);
        const Vec3 higher = size * Vec3{5, 4e-12, 5};
        check_orders(left, right, higher, {0, 0, 1});
    }
    check_none({0, 0, 0}, {1, 0, 0}, {1, 1e-13, 0});
    check_orders({0, 0, 0}, {1, 0, 0}, {1, 1e-11, 0}, {0, 0, 1});
}
