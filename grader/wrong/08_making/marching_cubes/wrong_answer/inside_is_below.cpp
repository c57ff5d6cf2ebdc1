// Takes the points below the level for the inside.
// Hint: Your surface is turned over: what you take for its inside is its
// outside.
#include "exercises/08_making/marching_cubes.h"

#include <cstdint>
#include <map>
#include <utility>

namespace {

void check_sizes(const DensityGrid& grid) {
    std::int64_t points = std::int64_t{grid.nx} * grid.ny * grid.nz;
    if (grid.nx < 0 || grid.ny < 0 || grid.nz < 0 ||
        std::ssize(grid.density) != points)
        throw std::invalid_argument("the grid is not of nx * ny * nz points");
}

class Surface {
public:
    Surface(const DensityGrid& grid, double level)
        : grid_(grid), level_(level) {}

    void add_cell(int i, int j, int k) {
        std::size_t number = 0;
        for (int c = 0; c < 8; ++c)
            if (density(corner(i, j, k, c)) < level_)
                number |= std::size_t{1} << c;
        const auto& edges = cell_triangles[number];
        for (std::size_t n = 0; edges[n] != -1; n += 3)
            mesh.faces.push_back({vertex(i, j, k, edges[n]),
                                  vertex(i, j, k, edges[n + 1]),
                                  vertex(i, j, k, edges[n + 2])});
    }

    IndexedMesh mesh;

private:
    /// The point of the grid that is corner c of a cell, by its place.
    int corner(int i, int j, int k, int c) const {
        int x = i + (c & 1), y = j + (c >> 1 & 1), z = k + (c >> 2 & 1);
        return x + grid_.nx * (y + grid_.ny * z);
    }

    double density(int point) const {
        return grid_.density[static_cast<std::size_t>(point)];
    }

    Vec3 position(int point) const {
        int x = point % grid_.nx, y = point / grid_.nx % grid_.ny;
        int z = point / grid_.nx / grid_.ny;
        return {static_cast<double>(x), static_cast<double>(y),
                static_cast<double>(z)};
    }

    /// The vertex on an edge of a cell; made when it is not there yet.
    int vertex(int i, int j, int k, int edge) {
        auto [from, to] = cell_edges[static_cast<std::size_t>(edge)];
        int a = corner(i, j, k, from), b = corner(i, j, k, to);
        auto [found, is_new] = number_.try_emplace({a, b}, mesh.vertex_count());
        if (is_new) {
            double t = (level_ - density(a)) / (density(b) - density(a));
            mesh.positions.push_back(position(a) +
                                     t * (position(b) - position(a)));
        }
        return found->second;
    }

    const DensityGrid& grid_;
    double level_;
    std::map<std::pair<int, int>, int> number_;  // by the ends of the edge
};

}  // namespace

IndexedMesh marching_cubes(const DensityGrid& grid, double level) {
    check_sizes(grid);
    Surface surface(grid, level);
    for (int k = 0; k + 1 < grid.nz; ++k)
        for (int j = 0; j + 1 < grid.ny; ++j)
            for (int i = 0; i + 1 < grid.nx; ++i) surface.add_cell(i, j, k);
    return surface.mesh;
}
