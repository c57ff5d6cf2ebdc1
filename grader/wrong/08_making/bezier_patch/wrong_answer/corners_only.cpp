// Interpolates between the four corners.
// Hint: From row to row you go straight, where there must be a curve.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    auto nu = static_cast<std::size_t>(grid.nu), n = grid.points.size();
    Vec3 low = (1 - u) * grid.points[0] + u * grid.points[nu - 1];
    Vec3 high = (1 - u) * grid.points[n - nu] + u * grid.points[n - 1];
    return (1 - v) * low + v * high;
}
