// Throws std::out_of_range where the contract says std::invalid_argument.
// Hint: Where the contract refuses, your program ends with another error than
// the one that it names.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::out_of_range("the grid is not of nu * nv points");

    std::vector<Vec3> across;  // the point at u of each row
    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> left = grid.points;
    while (!left.empty()) {
        across.push_back(bezier(left.first(nu), u));
        left = left.subspan(nu);
    }
    return bezier(across, v);
}
