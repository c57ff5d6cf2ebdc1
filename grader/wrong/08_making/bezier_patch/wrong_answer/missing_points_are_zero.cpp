// Fills a list that is too short with the origin.
// Hint: You accept a grid that the contract refuses.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1) throw std::invalid_argument("no grid");
    std::vector<Vec3> points = grid.points;
    points.resize(static_cast<std::size_t>(grid.nu) *
                  static_cast<std::size_t>(grid.nv));
    std::vector<Vec3> across;  // the point at u of each row
    auto nu = static_cast<std::size_t>(grid.nu);
    std::span<const Vec3> left = points;
    while (!left.empty()) {
        across.push_back(bezier(left.first(nu), u));
        left = left.subspan(nu);
    }
    return bezier(across, v);
}
