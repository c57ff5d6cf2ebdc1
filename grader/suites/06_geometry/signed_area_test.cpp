// Hidden suite of signed_area.
#include "exercises/06_geometry/signed_area.h"

#include <cmath>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

using hidden::Polygon;

/// The polygon begun at each of its corners, and the same the other way round.
/// `size` is an area of which the tolerance is a part.
void check_area(const Polygon& polygon, double area, double size) {
    const int n = static_cast<int>(polygon.size());
    for (int k = 0; k < n; k += 1 + n / 8) {
        const Polygon turned = hidden::begun_at(polygon, k);
        CHECK_THAT(signed_area(turned), IsAbout(area, size));
        CHECK_THAT(signed_area(hidden::reversed(turned)), IsAbout(-area, size));
    }
}

Polygon moved(Polygon polygon, double scale, Vec2 shift) {
    for (Vec2& p : polygon) p = shift + scale * p;
    return polygon;
}

constexpr double fine = 0x1p-20;

/// With coordinates that stay exact when the polygon is moved far away.
Polygon on_fine_grid(Polygon polygon) {
    for (Vec2& p : polygon)
        p = {fine * std::round(p.x / fine), fine * std::round(p.y / fine)};
    return polygon;
}

/// Of a small polygon on the fine grid, near the origin: in whole numbers.
double exact_area(const Polygon& polygon) {
    long long sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k];
        const Vec2 b = polygon[(k + 1) % polygon.size()];
        sum += std::llround(a.x / fine) * std::llround(b.y / fine) -
               std::llround(a.y / fine) * std::llround(b.x / fine);
    }
    return static_cast<double>(sum) * fine * fine / 2;
}

}  // namespace

TEST_CASE("triangles and convex polygons", "[points:2]") {
    hint("Is the side from the last corner to the first counted?");
    check_area({{0, 0}, {1, 0}, {0, 1}}, 0.5, 1);
    check_area({{-1, -2}, {5, -2}, {-1, 2}}, 12, 1);
    check_area({{2, 1}, {6, 3}, {5, 5}, {1, 3}}, 10, 1);
    check_area({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 2, 1);
    check_area(
        {{2, 0}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}},
        13.5, 1);
    check_area({{3, 5}, {5, 5}, {5, 8}, {3, 8}}, 6, 1);
}

TEST_CASE("polygons that are not convex", "[points:3]") {
    hint("May the sign of a triangle be left out? Are all of them inside?");
    hidden::Chance chance(650);
    for (int k = 0; k < 25; ++k) {
        const hidden::Columns columns =
            hidden::columns(1 + chance.below(12), chance);
        const Polygon polygon = columns.polygon();
        check_area(polygon, columns.area(), 1);
        check_area(moved(polygon, 1, {-37, 20}), columns.area(), 1e3);
        const hidden::Star star = hidden::star(5 + chance.below(20), chance);
        check_area(star.polygon(), star.area(), 1);
    }
}

TEST_CASE("small polygons and large ones", "[points:1]") {
    hint("By how much does the area grow when all lengths are doubled?");
    hidden::Chance chance(651);
    for (const double scale : {1e-6, 1e-3, 1e4, 1e7}) {
        const hidden::Star star = hidden::star(9, chance);
        check_area(moved(star.polygon(), scale, {}),
                   scale * scale * star.area(), 0);
        const hidden::Columns columns = hidden::columns(6, chance);
        check_area(moved(columns.polygon(), scale, {}),
                   scale * scale * columns.area(), 0);
    }
}

TEST_CASE("far away from the origin", "[points:2]") {
    hint("How large are the numbers that you multiply, and their product?");
    hidden::Chance chance(652);
    for (const Vec2 shift :
         {Vec2{1 << 21, 1 << 20}, Vec2{-1'000'000, 2'000'000}, Vec2{0, 3e6}}) {
        const Polygon polygon = on_fine_grid(hidden::star(8, chance).polygon());
        const double area = exact_area(polygon);
        check_area(polygon, area, 16);
        check_area(moved(polygon, 1, shift), area, 16);
        check_area(moved(polygon, 0x1p-20, 0x1p-20 * shift), 0x1p-40 * area,
                   0x1p-40 * 16);
    }
}

TEST_CASE("fewer than three corners, and corners on a line", "[points:1]") {
    hint("Which corners may be read when there are none?");
    CHECK(signed_area(Polygon{}) == 0);
    CHECK(signed_area(Polygon{{3, 4}}) == 0);
    CHECK(signed_area(Polygon{{3, 4}, {-1, 7}}) == 0);
    check_area({{0, 0}, {1, 2}, {3, 6}}, 0, 10);
    check_area({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, 0, 1);
    check_area({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}}, 16, 1);
    check_area({{0, 0}, {0, 0}, {4, 0}, {4, 3}, {4, 3}}, 6, 1);
}

TEST_CASE("a polygon of many corners", "[points:1]") {
    hint("How often is each corner looked at?");
    hidden::Chance chance(653);
    const hidden::Columns columns = hidden::columns(20000, chance);
    CHECK_THAT(signed_area(columns.polygon()), IsAbout(columns.area()));
}
