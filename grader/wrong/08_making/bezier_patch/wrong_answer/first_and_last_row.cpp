// Joins the curves of the first and the last row by a segment.
// Hint: From row to row you go straight, where there must be a curve.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> all = grid.points;
    return (1 - v) * bezier(all.first(nu), u) + v * bezier(all.last(nu), u);
}
