#include "course/player/pictures/cubes_picture.h"

#include <algorithm>

#include "course/mesh/marching_cubes_table.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/pictures/shapes.h"

namespace course {

namespace {

constexpr double level = 1;

DensityGrid cell_of(const DensityGrid& grid, std::array<int, 3> at) {
    DensityGrid cell{2, 2, 2, {}};
    for (int c = 0; c < 8; ++c) {
        const int x = at[0] + (c & 1), y = at[1] + (c >> 1 & 1),
                  z = at[2] + (c >> 2 & 1);
        const int point = x + grid.nx * (y + grid.ny * z);
        cell.density.push_back(grid.density[static_cast<std::size_t>(point)]);
    }
    return cell;
}

int case_of(const DensityGrid& cell, double at_level) {
    int number = 0;
    for (std::size_t c = 0; c < 8; ++c)
        if (cell.density[c] > at_level) number |= 1 << c;
    return number;
}

/// The edges of the table's row, up to its end.
std::vector<int> row_of_case(int number) {
    const auto& row = cell_triangles[static_cast<std::size_t>(number)];
    return {row.begin(), std::find(row.begin(), row.end(), -1)};
}

Json cell_json(const MarchedCell& cell) {
    return Json::object(
        {{"at", Json::array({cell.at[0], cell.at[1], cell.at[2]})},
         {"number", cell.number},
         {"row", row_of_case(cell.number)},
         {"mesh", mesh_json(cell.mesh)}});
}

Json grid_json(const DensityGrid& grid, const MarchingCubes& march) {
    std::vector<Json> cells;
    for (const MarchedCell& cell : marched_cells(grid, level, march))
        cells.push_back(cell_json(cell));
    return Json::object({{"size", Json::array({grid.nx, grid.ny, grid.nz})},
                         {"density", grid.density},
                         {"whole", mesh_json(march(grid, level))},
                         {"cells", cells}});
}

}  // namespace

std::vector<MarchedCell> marched_cells(const DensityGrid& grid, double at_level,
                                       const MarchingCubes& march) {
    std::vector<MarchedCell> cells;
    for (int k = 0; k + 1 < grid.nz; ++k)
        for (int j = 0; j + 1 < grid.ny; ++j)
            for (int i = 0; i + 1 < grid.nx; ++i) {
                const DensityGrid cell = cell_of(grid, {i, j, k});
                IndexedMesh mesh = march(cell, at_level);
                for (Vec3& p : mesh.positions)
                    p = p + Vec3{double(i), double(j), double(k)};
                if (!mesh.faces.empty())
                    cells.push_back(
                        {{i, j, k}, case_of(cell, at_level), std::move(mesh)});
            }
    return cells;
}

DensityGrid blob() {
    DensityGrid grid{4, 4, 4, {}};
    for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const Vec3 p =
                    Vec3{double(i), double(j), double(k)} - Vec3{1.4, 1.6, 1.3};
                grid.density.push_back(
                    std::round(100 * 1.5 / (0.5 + dot(p, p))) / 100);
            }
    return grid;
}

DensityGrid two_cells() {
    // Points (1, 0, 0) and (1, 1, 1) of 3 x 2 x 2.
    return {3, 2, 2, {0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0}};
}

std::string cubes_picture() {
    const MarchingCubes march("marching_cubes");
    std::vector<Json> edges;
    for (const auto& [from, to] : cell_edges)
        edges.push_back(Json::array({from, to}));
    return Json::object({{"level", level},
                         {"edges", edges},
                         {"blob", grid_json(blob(), march)},
                         {"two_cells", grid_json(two_cells(), march)}})
        .text();
}

}  // namespace course
