// Blends the four border curves (a Coons patch): right at the borders, and the
// inner control points do not count.
// Hint: Your patch is right along its borders, and the inner control points do
// not count as they should.
#include "exercises/08_making/bezier_patch.h"

#include <cstdint>
#include <vector>

Vec3 bezier_patch(const ControlGrid& grid, double u, double v) {
    if (grid.nu < 1 || grid.nv < 1 ||
        std::ssize(grid.points) != std::int64_t{grid.nu} * grid.nv)
        throw std::invalid_argument("the grid is not of nu * nv points");

    auto nu = static_cast<std::size_t>(grid.nu);
    auto n = grid.points.size();
    std::span<const Vec3> all = grid.points;
    std::vector<Vec3> west, east;
    for (std::size_t k = 0; k < n; k += nu) {
        west.push_back(all[k]);
        east.push_back(all[k + nu - 1]);
    }
    Vec3 rows = (1 - v) * bezier(all.first(nu), u) + v * bezier(all.last(nu), u);
    Vec3 columns = (1 - u) * bezier(west, v) + u * bezier(east, v);
    Vec3 low = (1 - u) * all[0] + u * all[nu - 1];
    Vec3 high = (1 - u) * all[n - nu] + u * all[n - 1];
    return rows + columns - ((1 - v) * low + v * high);
}
