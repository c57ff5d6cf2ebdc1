// Takes the mean of a curve along the middle row and one along the middle
// column.
// Hint: You use the points of some rows and columns only; each control point
// counts.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> all = grid.points;
    std::vector<Vec3> column;
    for (std::size_t k = nu / 2; k < all.size(); k += nu)
        column.push_back(all[k]);
    auto middle = static_cast<std::size_t>(grid.nv / 2) * nu;
    return 0.5 * (bezier(all.subspan(middle, nu), u) + bezier(column, v));
}
