// Cuts the squares into triangles.
// Hint: You cut the squares into triangles; quads were asked for.
#include "exercises/08_making/voxel_surface.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace {

using Point = std::array<int, 3>;

bool is_full(const VoxelGrid& grid, Point cell) {
    auto [i, j, k] = cell;
    if (i < 0 || j < 0 || k < 0 || i >= grid.nx || j >= grid.ny || k >= grid.nz)
        return false;
    return grid.full[static_cast<std::size_t>(i + grid.nx * (j + grid.ny * k))];
}

Point step(Point p, std::size_t axis, int by) {
    p[axis] += by;
    return p;
}

/// The side of a cell towards larger (by = 1) or smaller (by = -1) coordinates
/// of an axis, counter-clockwise seen from outside. With the next two axes u
/// and v in the order x, y, z, x, y: u turns to v seen from the tip of `axis`.
std::array<Point, 4> side(Point cell, std::size_t axis, int by) {
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Point a = by == 1 ? step(cell, axis, 1) : cell;
    Point b = step(a, u, 1), c = step(b, v, 1), d = step(a, v, 1);
    if (by == 1) return {a, b, c, d};
    return {a, d, c, b};
}

class Surface {
public:
    void add(const std::array<Point, 4>& corners) {
        std::vector<int> face;
        for (Point p : corners) face.push_back(vertex(p));
        mesh.faces.push_back({face[0], face[1], face[2]});
        mesh.faces.push_back({face[0], face[2], face[3]});
    }

    IndexedMesh mesh;

private:
    int vertex(Point p) {
        auto [found, is_new] = number_.try_emplace(p, mesh.vertex_count());
        if (is_new)
            mesh.positions.push_back({static_cast<double>(p[0]),
                                      static_cast<double>(p[1]),
                                      static_cast<double>(p[2])});
        return found->second;
    }

    std::map<Point, int> number_;
};

void check_sizes(const VoxelGrid& grid) {
    std::int64_t cells = std::int64_t{grid.nx} * grid.ny * grid.nz;
    if (grid.nx < 0 || grid.ny < 0 || grid.nz < 0 ||
        std::ssize(grid.full) != cells)
        throw std::invalid_argument("the grid is not of nx * ny * nz cells");
}

}  // namespace

IndexedMesh voxel_surface(const VoxelGrid& grid) {
    check_sizes(grid);
    Surface surface;
    for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                Point cell = {i, j, k};
                if (!is_full(grid, cell)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (int by : {1, -1})
                        if (!is_full(grid, step(cell, axis, by)))
                            surface.add(side(cell, axis, by));
            }
    return surface.mesh;
}
