// Uses places in z as vertex numbers, as if no hole came before.
// Hint: Your vertices are right, and your triangles too, until there is a
// hole: then some are missing or have other corners.
#include "exercises/08_making/height_field.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

void check_sizes(const HeightGrid& grid) {
    std::int64_t points = std::int64_t{grid.nx} * grid.ny;
    if (grid.nx < 0 || grid.ny < 0 || std::ssize(grid.z) != points)
        throw std::invalid_argument(std::to_string(grid.z.size()) +
                                    " heights for " + std::to_string(grid.nx) +
                                    " x " + std::to_string(grid.ny));
}

}  // namespace

IndexedMesh height_field(const HeightGrid& grid) {
    check_sizes(grid);
    IndexedMesh mesh;
    std::vector<int> vertex(grid.z.size(), -1);  // -1: a hole
    auto at = [&](int i, int j) {
        return static_cast<std::size_t>(i + grid.nx * j);
    };
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            double z = grid.z[at(i, j)];
            if (std::isnan(z)) continue;
            vertex[at(i, j)] = i + grid.nx * j;
            mesh.positions.push_back(
                {static_cast<double>(i), static_cast<double>(j), z});
        }

    for (int j = 0; j + 1 < grid.ny; ++j)
        for (int i = 0; i + 1 < grid.nx; ++i) {
            std::vector<int> corners;
            for (int v : {vertex[at(i, j)], vertex[at(i + 1, j)],
                          vertex[at(i + 1, j + 1)], vertex[at(i, j + 1)]})
                if (v != -1) corners.push_back(v);
            for (std::size_t k = 2; k < corners.size(); ++k)
                mesh.faces.push_back({corners[0], corners[k - 1], corners[k]});
        }
    return mesh;
}
