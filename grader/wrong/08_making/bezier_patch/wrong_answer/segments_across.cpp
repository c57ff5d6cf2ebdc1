// Walks along segments from the point of one row to that of the next.
// Hint: From row to row you go straight, where there must be a curve.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    std::vector<Vec3> across;  // the point at u of each row
    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> left = grid.points;
    while (!left.empty()) {
        across.push_back(bezier(left.first(nu), u));
        left = left.subspan(nu);
    }
    double at = v * static_cast<double>(across.size() - 1);
    auto k = static_cast<std::size_t>(at);
    if (k + 1 >= across.size()) return across.back();
    double part = at - static_cast<double>(k);
    return (1 - part) * across[k] + part * across[k + 1];
}
