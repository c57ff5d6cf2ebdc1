// Hidden suite of contains.
#include "exercises/06_geometry/contains.h"

#include <cmath>
#include <utility>

#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

using hidden::Polygon;

/// A similarity of the plane by powers of two and whole steps, which keeps
/// whole numbers exact: quarter turns, a mirror, a scale, a shift.
struct Grid {
    int quarters;
    bool mirrored;
    double scale;
    Vec2 shift;

    Vec2 operator()(Vec2 p) const {
        if (mirrored) p = {p.y, p.x};
        for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
        return shift + scale * p;
    }
};

const Grid grids[] = {{0, false, 1, {0, 0}},       {1, false, 1, {0, 0}},
                      {2, false, 4, {-12, 40}},    {3, false, 0x1p-10, {0, 0}},
                      {0, true, 1, {1000, -2000}}, {1, true, 0x1p13, {0, 0}},
                      {2, true, 1, {0, 0}},        {3, true, 0.5, {-3, 7}}};

/// Asks for p in the polygon, begun anywhere and in either direction.
void check_inside(const Polygon& polygon, Vec2 p, bool inside, int start) {
    const int n = static_cast<int>(polygon.size());
    const Polygon turned = hidden::begun_at(polygon, start % n);
    CHECK(contains(turned, p) == inside);
    CHECK(contains(hidden::reversed(turned), p) == inside);
}

Polygon placed(const Grid& grid, Polygon polygon) {
    for (Vec2& p : polygon) p = grid(p);
    return polygon;
}

/// Each p that is a multiple of `step`, round the columns and in them.
template <class Ask>
void for_each_point(int columns, double step, Ask ask) {
    for (double x = -1.5; x <= columns + 1.5; x += step)
        for (double y = -5.5; y <= 5.5; y += step) ask(Vec2{x, y});
}

/// Columns asked at every point of a grid that is not on the border.
void check_columns(const hidden::Columns& columns, const Grid& grid) {
    const Polygon polygon = placed(grid, columns.polygon());
    int start = 0;
    for_each_point(static_cast<int>(columns.low.size()), 0.5, [&](Vec2 p) {
        if (!columns.on_border(p))
            check_inside(polygon, grid(p), columns.inside(p), start++);
    });
}

}  // namespace

TEST_CASE("stars, turned by any angle", "[points:3]") {
    hint("Does the number of sides that you cross tell inside from outside?");
    hidden::Chance chance(660);
    for (int k = 0; k < 30; ++k) {
        const hidden::Star star = hidden::star(5 + chance.below(20), chance);
        const double scale = k % 3 == 0 ? 1e-3 : (k % 3 == 1 ? 1 : 1e4);
        const Vec2 shift = scale * Vec2{chance.between(-9, 9), 3};
        Polygon polygon = star.polygon();
        for (Vec2& p : polygon) p = shift + scale * p;
        for (int i = 0; i < 20; ++i) {
            const Vec2 p{chance.between(-2.2, 2.2), chance.between(-2.2, 2.2)};
            if (star.clear_of_border(p, 1e-4))
                check_inside(polygon, shift + scale * p, star.inside(p), i);
        }
    }
}

TEST_CASE("columns, at heights between those of the corners", "[points:2]") {
    hint("Which sides are beside p, and which of these are behind you?");
    hidden::Chance chance(661);
    for (const Grid& grid : grids) {
        const hidden::Columns columns = hidden::columns(7, chance);
        const Polygon polygon = placed(grid, columns.polygon());
        int start = 0;
        for (int i = 0; i < 80; ++i) {
            const Vec2 p{chance.below(10) - 1 + chance.between(0.1, 0.9),
                         chance.below(12) - 6 + chance.between(0.1, 0.9)};
            check_inside(polygon, grid(p), columns.inside(p), start++);
        }
    }
}

TEST_CASE("columns, at the heights of corners and along their sides",
          "[points:3]") {
    hint("What does the walk do at a corner, and along a side?");
    hidden::Chance chance(662);
    for (const Grid& grid : grids)
        check_columns(hidden::columns(4 + chance.below(3), chance), grid);
}

TEST_CASE("slanting sides whose corners are at the height of p", "[points:3]") {
    hint("Where the way goes through a corner: does the border get across?");
    // Two teeth up, two down, and a notch; corners at whole heights.
    const Polygon teeth{{0, 0}, {2, -4}, {4, 0}, {6, -4}, {8, 0}, {8, 4},
                        {6, 2}, {4, 4},  {3, 2}, {2, 4},  {1, 2}, {0, 4}};
    const std::vector<std::pair<Vec2, bool>> points{
        {{1, 0}, true},   {{4, 0.5}, true}, {{7, 0}, true},   {{-1, 0}, false},
        {{9, 0}, false},  {{-1, 4}, false}, {{-1, 2}, false}, {{0.5, 2}, true},
        {{2, 2}, true},   {{4, 2}, true},   {{7, 2}, true},   {{9, 2}, false},
        {{1, 4}, false},  {{3, 4}, false},  {{5, 4}, false},  {{9, 4}, false},
        {{2, -3}, true},  {{6, -3}, true},  {{4, -1}, false}, {{4, -4}, false},
        {{0, -4}, false}, {{7, -4}, false}, {{2, 3}, true},   {{4, 3}, true},
        {{1, 3}, false},  {{3, 3}, false},  {{6, 3}, false},  {{2, 0}, true},
        {{6, 0}, true},   {{3, 0}, true},   {{1, 1}, true},   {{3, 1}, true},
        {{6, 1}, true},   {{2, 5}, false},  {{4, 5}, false},  {{2, -5}, false}};
    for (const Grid& grid : grids) {
        int start = 0;
        for (const auto& [p, inside] : points)
            check_inside(placed(grid, teeth), grid(p), inside, start++);
    }
    const Polygon diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
    for (const Grid& grid : grids)
        for (int x = -4; x <= 4; ++x)
            for (int y = -4; y <= 4; ++y)
                if (std::abs(x) + std::abs(y) != 2)
                    check_inside(placed(grid, diamond),
                                 grid({x * 1.0, y * 1.0}),
                                 std::abs(x) + std::abs(y) < 2, x + 4);
}

TEST_CASE("sides in line, also at the height of p", "[points:1]") {
    hint("What if several sides in a row lie along the way?");
    // A U whose sides are cut up.
    const Polygon u{{0, 0}, {2, 0}, {3, 0}, {6, 0}, {6, 2}, {6, 4},
                    {5, 4}, {4, 4}, {4, 2}, {3, 2}, {2, 2}, {2, 4},
                    {1, 4}, {0, 4}, {0, 3}, {0, 2}};
    for (const Grid& grid : grids) {
        int start = 0;
        for (const Vec2 p : {Vec2{1, 2}, {5, 2}, {3, 1}, {1, 3}, {5, 3}})
            check_inside(placed(grid, u), grid(p), true, start++);
        for (const Vec2 p : {Vec2{-1, 2},
                             {7, 2},
                             {3, 3},
                             {3, 4},
                             {-1, 4},
                             {-1, 0},
                             {7, 0},
                             {7, 4},
                             {3, 5},
                             {3, -1}})
            check_inside(placed(grid, u), grid(p), false, start++);
    }
}

TEST_CASE("fewer than three corners", "[points:1]") {
    hint("Which corners may be read when there are none?");
    CHECK_FALSE(contains(Polygon{}, {0, 0}));
    CHECK_FALSE(contains(Polygon{{1, 1}}, {0, 1}));
    CHECK_FALSE(contains(Polygon{{0, 0}, {4, 2}}, {1, 1}));
    CHECK_FALSE(contains(Polygon{{0, 0}, {4, 2}}, {3, 1}));
    CHECK_FALSE(contains(Polygon{{4, 2}, {0, 0}}, {1, 1}));
}

TEST_CASE("a polygon of many corners", "[points:1]") {
    hint("How often is each corner looked at?");
    hidden::Chance chance(663);
    const hidden::Columns columns = hidden::columns(20000, chance);
    const Polygon polygon = columns.polygon();
    for (int k = 0; k < 6; ++k) {
        const Vec2 p{chance.below(20000) + 0.5, k - 2.5};
        CHECK(contains(polygon, p) == columns.inside(p));
    }
}
