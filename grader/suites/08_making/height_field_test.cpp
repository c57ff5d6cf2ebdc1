// Hidden suite of height_field: any diagonals and any order pass.
#include "exercises/08_making/height_field.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

using Cell = std::pair<int, int>;  // its lower left point

/// The vertices, as a list of the grid's points that have a height.
std::vector<Vec3> vertices(const HeightGrid& grid) {
    std::vector<Vec3> found;
    for (std::size_t k = 0; k < grid.z.size(); ++k) {
        const int place = static_cast<int>(k);
        const double x = place % grid.nx, y = place / grid.nx;
        if (grid.z[k] == grid.z[k]) found.push_back({x, y, grid.z[k]});
    }
    return found;
}

/// The corner of the unit square that a triangle leaves out, and the square.
struct Half {
    Cell cell;
    Cell left_out;
};

/// nullopt when the triangle is not half a cell of the grid.
std::optional<Half> half(const std::vector<Vec3>& corners) {
    std::set<int> xs, ys;
    int x_sum = 0, y_sum = 0;
    for (const Vec3 p : corners) {
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        xs.insert(x), ys.insert(y);
        x_sum += x, y_sum += y;
    }
    if (xs.size() != 2 || ys.size() != 2) return std::nullopt;
    const int x = *xs.begin(), y = *ys.begin();
    if (*xs.rbegin() != x + 1 || *ys.rbegin() != y + 1) return std::nullopt;
    return Half{{x, y}, {4 * x + 2 - x_sum, 4 * y + 2 - y_sum}};
}

/// Which halves each cell must have: by how many of its corners have heights.
std::string bad_cell(const HeightGrid& grid, Cell cell,
                     const std::vector<Cell>& left_out) {
    const auto [x, y] = cell;
    std::vector<Cell> holes;
    for (const Cell& p : {cell, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}) {
        const auto k = static_cast<std::size_t>(p.first + grid.nx * p.second);
        if (grid.z[k] != grid.z[k]) holes.push_back(p);
    }
    const std::string name =
        "the cell of (" + std::to_string(x) + ", " + std::to_string(y) + ") ";
    const std::size_t wanted = holes.empty() ? 2 : holes.size() == 1 ? 1 : 0;
    if (left_out.size() != wanted)
        return name + "has " + std::to_string(left_out.size()) +
               " triangles, not " + std::to_string(wanted);
    if (wanted == 2 && (left_out[0].first == left_out[1].first ||
                        left_out[0].second == left_out[1].second))
        return name + "has two triangles that overlap";
    return "";
}

std::string bad_faces(const HeightGrid& grid, const IndexedMesh& mesh) {
    std::map<Cell, std::vector<Cell>> left_out;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<Vec3> corners;
        for (const int v : mesh.faces[f])
            corners.push_back(mesh.positions[static_cast<std::size_t>(v)]);
        const auto found = half(corners);
        const std::string name = "triangle " + std::to_string(f);
        if (!found) return name + " is not half a cell";
        if (!(oracle::doubled_area(mesh, mesh.faces[f]).z > 0))
            return name + " looks down";
        left_out[found->cell].push_back(found->left_out);
    }
    for (int y = 0; y + 1 < grid.ny; ++y)
        for (int x = 0; x + 1 < grid.nx; ++x) {
            const std::string why = bad_cell(grid, {x, y}, left_out[{x, y}]);
            if (!why.empty()) return why;
        }
    return "";
}

/// Positions are compared exactly: they are copied, not computed.
oracle::FaultMatcher<IndexedMesh> IsTerrain(const HeightGrid& grid) {
    return {"the terrain of these heights", [=](const IndexedMesh& mesh) {
                const std::vector<Vec3> wanted = vertices(grid);
                if (mesh.positions.size() != wanted.size())
                    return "has " + std::to_string(mesh.vertex_count()) +
                           " vertices, not " + std::to_string(wanted.size());
                for (std::size_t v = 0; v < wanted.size(); ++v)
                    if (!(mesh.positions[v] == wanted[v]))
                        return "vertex " + std::to_string(v) + " is not at " +
                               show(wanted[v]);
                std::string why = oracle::malformed_mesh(mesh, 3);
                return why.empty() ? bad_faces(grid, mesh) : why;
            }};
}

void check(const HeightGrid& grid) {
    REQUIRE_THAT(height_field(grid), IsTerrain(grid));
}

/// Heights from the seed, below and above 0; some of them missing.
HeightGrid random_grid(int nx, int ny, int holes_percent, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    HeightGrid grid{nx, ny, {}};
    for (int k = 0; k < nx * ny; ++k) {
        const auto r = static_cast<int>(next() % 4000);
        const bool is_hole = static_cast<int>(next() % 100) < holes_percent;
        grid.z.push_back(is_hole ? NAN : (r - 2000) / 64.0);
    }
    return grid;
}

}  // namespace

TEST_CASE("full grids", "[points:2]") {
    hint("Which points are the lower left corner of a cell?");
    check({2, 2, {1, 2, 3, 5}});
    check({3, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0}});
    check(random_grid(4, 4, 0, 1));
    check(random_grid(7, 7, 0, 2));
}

TEST_CASE("grids that are not square", "[points:1]") {
    hint("How far apart in z are a point and the one above it?");
    check(random_grid(5, 3, 0, 3));
    check(random_grid(2, 9, 0, 4));
    check(random_grid(9, 2, 0, 5));
    check({4, 2, {-1, -2, -3, -4, 1e6, 0, -0.0, 1e-9}});
}

TEST_CASE("a cell with one hole, at any corner", "[points:1]") {
    hint("How do the three corners that are left run, seen from above?");
    for (std::size_t hole = 0; hole < 4; ++hole) {
        HeightGrid grid{2, 2, {1, -2, 0, 4}};
        grid.z[hole] = NAN;
        check(grid);
        grid.z[hole] = -std::numeric_limits<double>::quiet_NaN();
        check(grid);
    }
}

TEST_CASE("any holes in a cell", "[points:1]") {
    hint("How many heights does a triangle need?");
    for (unsigned holes = 0; holes < 16; ++holes) {
        HeightGrid grid{2, 2, {3, 0, 2, 1}};
        for (unsigned k = 0; k < 4; ++k)
            if ((holes >> k & 1) != 0) grid.z[k] = NAN;
        check(grid);
    }
}

TEST_CASE("terrains with holes", "[points:2]") {
    hint("Which vertex stands over a point that comes after a hole?");
    for (std::uint64_t salt = 10; salt < 40; ++salt) {
        const int nx = 2 + static_cast<int>(salt % 7);
        const int ny = 2 + static_cast<int>(salt % 5);
        check(random_grid(nx, ny, static_cast<int>(salt), salt));
    }
    check(random_grid(6, 6, 90, 41));
    check({3, 2, {NAN, NAN, NAN, NAN, NAN, NAN}});
}

TEST_CASE("one row, one column, one point, none", "[points:1]") {
    hint("How many cells are there? Do the points still have vertices?");
    check({1, 5, {1, 2, NAN, 4, 5}});
    check({5, 1, {1, 2, 3, NAN, 5}});
    check({1, 1, {7}});
    check({1, 1, {NAN}});
    for (const auto& [nx, ny] : {Cell{0, 0}, {0, 4}, {3, 0}}) {
        const IndexedMesh none = height_field({nx, ny, {}});
        CHECK(none.positions.empty());
        CHECK(none.faces.empty());
    }
}

TEST_CASE("sizes that do not fit are refused", "[points:1]") {
    hint("Which numbers of rows and columns are no grid?");
    const std::vector<double> four = {1, 2, 3, 4};
    for (const HeightGrid& grid :
         {HeightGrid{2, 2, {}}, HeightGrid{2, 3, four}, HeightGrid{1, 2, four},
          HeightGrid{-2, -2, four}, HeightGrid{-1, -4, four},
          HeightGrid{0, 4, four}, HeightGrid{4, 0, four}, HeightGrid{-1, 0, {}},
          HeightGrid{0, -1, {}}, HeightGrid{1 << 16, 1 << 16, {}}})
        CHECK_THROWS_AS(height_field(grid), std::invalid_argument);
}

TEST_CASE("the cost grows no faster than the grid", "[points:1][once]") {
    hint("How do you get from a point to the number of its vertex?");
    check(random_grid(80, 80, 3, 50));
}
