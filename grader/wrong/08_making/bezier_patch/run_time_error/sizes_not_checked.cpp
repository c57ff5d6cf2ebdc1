// Reads rows of a list that is too short.
// Hint: Where the contract refuses, your program ends with another error than
// the one that it names.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.points.empty() || grid.nu < 1)
        throw std::invalid_argument("no points");
    std::vector<Vec3> across;  // the point at u of each row
    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> left = grid.points;
    while (!left.empty()) {
        across.push_back(bezier(left.first(nu), u));
        left = left.subspan(nu);
    }
    return bezier(across, v);
}
