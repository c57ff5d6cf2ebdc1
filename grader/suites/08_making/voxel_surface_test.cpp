// Hidden suite of voxel_surface: any numbering and any order pass.
#include "exercises/08_making/voxel_surface.h"

#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

using Cell = std::tuple<int, int, int>;

bool is_full(const VoxelGrid& grid, const Cell& cell) {
    const auto [x, y, z] = cell;
    if (std::min({x, y, z}) < 0 || x >= grid.nx || y >= grid.ny || z >= grid.nz)
        return false;
    return grid.full[static_cast<std::size_t>((z * grid.ny + y) * grid.nx + x)];
}

/// How many sides of full cells have no full cell behind them.
int count_sides(const VoxelGrid& grid) {
    int sides = 0;
    for (int z = 0; z < grid.nz; ++z)
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x)
                for (const Cell& next : {Cell{x + 1, y, z},
                                         {x, y + 1, z},
                                         {x, y, z + 1},
                                         {x - 1, y, z},
                                         {x, y - 1, z},
                                         {x, y, z - 1}})
                    sides += is_full(grid, {x, y, z}) && !is_full(grid, next);
    return sides;
}

std::string bad_vertices(const VoxelGrid& grid, const IndexedMesh& mesh) {
    const std::set<int> used(mesh.faces.corners().begin(),
                             mesh.faces.corners().end());
    std::set<std::tuple<double, double, double>> places;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const std::string name = "vertex " + std::to_string(v);
        const Vec3 p = mesh.positions[static_cast<std::size_t>(v)];
        if (p.x != std::round(p.x) || p.y != std::round(p.y) ||
            p.z != std::round(p.z) || std::min({p.x, p.y, p.z}) < 0 ||
            p.x > grid.nx || p.y > grid.ny || p.z > grid.nz)
            return name + " is no corner of a cell";
        if (!used.contains(v)) return name + " is used by no quad";
        if (!places.insert({p.x, p.y, p.z}).second)
            return name + " is in the place of another one";
    }
    return "";
}

bool is_unit(Vec3 a) {
    return dot(a, a) == 1 && (a.x == 0) + (a.y == 0) + (a.z == 0) == 2;
}

Cell cell_round(Vec3 middle) {
    return {static_cast<int>(std::floor(middle.x)),
            static_cast<int>(std::floor(middle.y)),
            static_cast<int>(std::floor(middle.z))};
}

/// The cells behind and before each quad must be a full and an empty one.
std::string bad_quads(const VoxelGrid& grid, const IndexedMesh& mesh) {
    std::set<std::pair<Cell, Cell>> seen;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::string name = "quad " + std::to_string(f);
        std::array<Vec3, 4> p;
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = mesh.positions[static_cast<std::size_t>(mesh.faces[f][k])];
        const Vec3 a = p[1] - p[0], b = p[3] - p[0];
        if (!is_unit(a) || !is_unit(b) || dot(a, b) != 0 || !(p[2] == p[1] + b))
            return name + " is no square of the grid";
        const Vec3 middle = 0.5 * (p[0] + p[2]), half = 0.5 * cross(a, b);
        const Cell behind = cell_round(middle - half);
        const Cell before = cell_round(middle + half);
        if (!is_full(grid, behind) && is_full(grid, before))
            return name + " looks inwards";
        if (!is_full(grid, behind) || is_full(grid, before))
            return name + " is not between a full and an empty cell";
        if (!seen.insert({behind, before}).second)
            return name + " is there twice";
    }
    const int wanted = count_sides(grid);
    if (mesh.faces.size() != wanted)
        return "has " + std::to_string(mesh.faces.size()) + " quads, not " +
               std::to_string(wanted);
    return "";
}

oracle::FaultMatcher<IndexedMesh> IsSurfaceOf(const VoxelGrid& grid) {
    return {"the surface of the full cells", [=](const IndexedMesh& mesh) {
                std::string why = oracle::malformed_mesh(mesh, 4);
                if (why.empty()) why = bad_vertices(grid, mesh);
                if (why.empty()) why = bad_quads(grid, mesh);
                return why;
            }};
}

void check(const VoxelGrid& grid) {
    REQUIRE_THAT(voxel_surface(grid), IsSurfaceOf(grid));
}

VoxelGrid all_empty(int nx, int ny, int nz) {
    const auto cells = static_cast<std::size_t>(nx * ny * nz);
    return {nx, ny, nz, std::vector<bool>(cells)};
}

VoxelGrid with_full(VoxelGrid grid, const std::vector<Cell>& cells) {
    for (const auto& [x, y, z] : cells)
        grid.full[static_cast<std::size_t>((z * grid.ny + y) * grid.nx + x)] =
            true;
    return grid;
}

VoxelGrid random_grid(int nx, int ny, int nz, int percent, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    VoxelGrid grid = all_empty(nx, ny, nz);
    for (std::size_t k = 0; k < grid.full.size(); ++k)
        grid.full[k] = static_cast<int>(next() % 100) < percent;
    return grid;
}

}  // namespace

TEST_CASE("cells that share a side, in each direction", "[points:2]") {
    hint("Which of the twelve sides of two cells are on the outside?");
    check(with_full(all_empty(4, 4, 4), {{1, 1, 1}}));
    for (const Cell& next : {Cell{2, 1, 1}, {1, 2, 1}, {1, 1, 2}})
        check(with_full(all_empty(4, 4, 4), {{1, 1, 1}, next}));
    check(with_full(all_empty(5, 4, 4),
                    {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}, {2, 2, 1}, {2, 2, 2}}));
}

TEST_CASE("full cells at the rim of the grid", "[points:2]") {
    hint(
        "What is beyond the last cell? Is the next one in the list beside it?");
    check({2, 2, 2, std::vector<bool>(8, true)});
    check({4, 3, 2, std::vector<bool>(24, true)});
    check({1, 1, 5, {true, false, true, true, true}});
    check({1, 5, 1, {true, true, false, true, true}});
    for (const int x : {0, 3})
        for (const int y : {0, 2})
            for (const int z : {0, 1})
                check(with_full(all_empty(4, 3, 2), {{x, y, z}}));
    check(with_full(all_empty(3, 3, 3),
                    {{2, 0, 0}, {0, 1, 0}, {2, 2, 1}, {0, 0, 2}}));
}

TEST_CASE("cells that touch at an edge or a corner only", "[points:1]") {
    hint("Which vertices do the two cells have in common, and which quads?");
    for (const Cell& next : {Cell{1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}})
        check(with_full(all_empty(2, 2, 2), {{0, 0, 0}, next}));
    check(with_full(all_empty(2, 2, 2), {{1, 0, 0}, {0, 1, 0}}));
    check(with_full(all_empty(2, 2, 2),
                    {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}));
}

TEST_CASE("a hole inside, and a hole right through", "[points:1]") {
    hint("On which side of a square is the empty cell?");
    VoxelGrid hollow = {3, 3, 3, std::vector<bool>(27, true)};
    hollow.full[13] = false;
    check(hollow);
    for (const std::size_t k : {4u, 22u}) hollow.full[k] = false;
    check(hollow);
}

TEST_CASE("random cells", "[points:2]") {
    hint("Compare with a small grid that you have solved on paper.");
    for (std::uint64_t salt = 0; salt < 24; ++salt) {
        const int r = static_cast<int>(salt);
        check(random_grid(2 + r % 5, 1 + r % 3, 2 + r % 4, 15 + 3 * r, salt));
    }
    check(random_grid(6, 5, 4, 50, 30));
}

TEST_CASE("nothing full, and no cells", "[points:1]") {
    hint("What is left to return when there is no full cell?");
    check(all_empty(3, 2, 2));
    check(with_full(all_empty(3, 2, 2), {{1, 0, 1}}));
    for (const VoxelGrid& grid :
         {VoxelGrid{0, 0, 0, {}}, VoxelGrid{0, 3, 2, {}},
          VoxelGrid{4, 0, 1, {}}, VoxelGrid{2, 2, 0, {}}}) {
        const IndexedMesh none = voxel_surface(grid);
        CHECK(none.positions.empty());
        CHECK(none.faces.empty());
    }
}

TEST_CASE("sizes that do not fit are refused", "[points:1]") {
    hint("Which three numbers are no sizes of a grid?");
    const std::vector<bool> eight(8, true);
    for (const VoxelGrid& grid :
         {VoxelGrid{2, 2, 2, {}}, VoxelGrid{2, 2, 3, eight},
          VoxelGrid{2, 2, 1, eight}, VoxelGrid{-2, -2, 2, eight},
          VoxelGrid{-1, 8, -1, eight}, VoxelGrid{2, -4, -1, eight},
          VoxelGrid{0, 2, 2, eight}, VoxelGrid{-1, 0, 0, {}},
          VoxelGrid{0, -3, 0, {}}, VoxelGrid{0, 0, -1, {}}})
        CHECK_THROWS_AS(voxel_surface(grid), std::invalid_argument);
}

TEST_CASE("the cost grows no faster than the grid", "[points:1][once]") {
    hint("How do you find out whether a corner has a vertex already?");
    // Cells that are apart from each other have the most corners.
    VoxelGrid apart = all_empty(15, 15, 11);
    for (int z = 0; z < 11; z += 2)
        for (int y = 0; y < 15; y += 2)
            for (int x = 0; x < 15; x += 2)
                apart.full[static_cast<std::size_t>((z * 15 + y) * 15 + x)] =
                    true;
    for (int k = 0; k < 3; ++k) check(apart);
}
