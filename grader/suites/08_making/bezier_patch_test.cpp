// Hidden suite of bezier_patch.
#include "exercises/08_making/bezier_patch.h"

#include <random>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/08_making/bezier_sums.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

const std::vector<double> parameters = {0, 0.15, 1.0 / 3, 0.5, 0.7, 0.96, 1};

ControlGrid random_grid(int nu, int nv, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    const auto number = [&] {
        return static_cast<double>(next() >> 11) / 0x1p52 - 1;
    };
    ControlGrid grid{nu, nv, {}};
    for (int k = 0; k < nu * nv; ++k) {
        const double x = number(), y = number(), z = number();
        grid.points.push_back({x, y, z});
    }
    return grid;
}

/// Compares with the sum over all control points; for points of about 1.
void check(const ControlGrid& grid) {
    for (const double u : parameters)
        for (const double v : parameters) {
            INFO("u " << u << ", v " << v);
            REQUIRE_THAT(bezier_patch(grid, u, v),
                         IsAt(oracle::bezier_patch_sum(grid, u, v), 1));
        }
}

}  // namespace

TEST_CASE("flat grids stay flat, and even", "[points:1]") {
    hint("Which parameter runs along which direction of the grid?");
    for (const auto& [nu, nv] : {std::pair{2, 2}, {4, 3}, {3, 5}}) {
        ControlGrid grid{nu, nv, {}};
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i)
                grid.points.push_back({1.0 * i, 2.0 * j, 1.0 + i - j});
        for (const double u : parameters)
            for (const double v : parameters) {
                const double i = u * (nu - 1), j = v * (nv - 1);
                CHECK_THAT(bezier_patch(grid, u, v),
                           IsAt({i, 2 * j, 1 + i - j}, 1));
            }
    }
}

TEST_CASE("square grids", "[points:2]") {
    hint("Of which points is the last curve made, and where is it asked?");
    for (int n = 2; n < 6; ++n)
        for (std::uint64_t salt = 0; salt < 2; ++salt)
            check(random_grid(n, n, 10 * salt + static_cast<std::uint64_t>(n)));
}

TEST_CASE("grids with more rows than columns, and with fewer", "[points:2]") {
    hint("How many points has a row, and how many rows are there?");
    for (const auto& [nu, nv] :
         {std::pair{2, 3}, {3, 2}, {4, 2}, {2, 5}, {5, 3}, {3, 7}})
        check(
            random_grid(nu, nv, static_cast<std::uint64_t>(30 + nu + 7 * nv)));
}

TEST_CASE("one row, one column, one point", "[points:1]") {
    hint("Which of the two parameters does not matter here?");
    for (const auto& [nu, nv] :
         {std::pair{1, 1}, {1, 4}, {4, 1}, {1, 2}, {2, 1}, {1, 9}})
        check(
            random_grid(nu, nv, static_cast<std::uint64_t>(60 + nu + 10 * nv)));
}

TEST_CASE("only the middle of the grid is raised", "[points:1]") {
    hint("Which control points does a point in the middle depend on?");
    for (int middle = 0; middle < 4; ++middle) {
        ControlGrid grid{4, 4, {}};
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                grid.points.push_back({1.0 * i, 1.0 * j, 0});
        const int i = 1 + middle % 2, j = 1 + middle / 2;
        grid.points[static_cast<std::size_t>(i + 4 * j)].z = 64;
        CHECK_THAT(bezier_patch(grid, 0.5, 0.5), IsAt({1.5, 1.5, 9}, 1));
        check(grid);
    }
}

TEST_CASE("the patch moves with its control points", "[points:1]") {
    hint("Do you use anything but weighted means of the points?");
    const ControlGrid grid = random_grid(4, 3, 80);
    for (const double scale : {1e-3, 1.0, 1e4}) {
        const Vec3 by = scale * Vec3{-4, 1, 3};
        const ControlGrid moved = {4, 3, oracle::moved(grid.points, scale, by)};
        for (const double u : parameters)
            for (const double v : parameters) {
                const Vec3 here[] = {oracle::bezier_patch_sum(grid, u, v)};
                CHECK_THAT(bezier_patch(moved, u, v),
                           IsAt(oracle::moved(here, scale, by)[0], scale));
            }
    }
}

TEST_CASE("sizes that do not fit are refused", "[points:1]") {
    hint("Which two numbers are no sizes of a grid of control points?");
    const std::vector<Vec3> six(6, Vec3{1, 2, 3});
    for (const ControlGrid& grid :
         {ControlGrid{0, 0, {}}, ControlGrid{2, 3, {}}, ControlGrid{2, 2, six},
          ControlGrid{3, 3, six}, ControlGrid{6, 0, six},
          ControlGrid{0, 6, six}, ControlGrid{-2, -3, six},
          ControlGrid{-1, -6, six}, ControlGrid{3, 0, {}},
          ControlGrid{0, 2, {}}, ControlGrid{-1, 0, {}}})
        CHECK_THROWS_AS(bezier_patch(grid, 0.5, 0.5), std::invalid_argument);
}

TEST_CASE("many control points", "[points:1]") {
    hint("How often is each row asked for its point?");
    for (const auto& [nu, nv] : {std::pair{30, 20}, {9, 40}}) {
        const ControlGrid grid =
            random_grid(nu, nv, static_cast<std::uint64_t>(90 + nu));
        for (const double u : {0.2, 0.6})
            for (const double v : {0.4, 0.9})
                CHECK_THAT(bezier_patch(grid, u, v),
                           IsAt(oracle::bezier_patch_sum(grid, u, v), 1));
    }
}
