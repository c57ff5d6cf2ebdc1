// Hidden suite of marching_cubes: properties only, so that other tables pass.
#include "exercises/08_making/marching_cubes.h"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

/// A point of the grid, or a cell by its lowest corner.
using Point = std::array<int, 3>;

/// An edge of the grid by the sum of its ends, the middle times two: odd in
/// one place.
using Edge = std::array<int, 3>;

std::size_t axis_of(const Edge& edge) {
    return edge[0] % 2 != 0 ? 0 : edge[1] % 2 != 0 ? 1 : 2;
}

/// What is asked about one grid and one mesh.
class Check {
public:
    Check(const DensityGrid& grid, double level, const IndexedMesh& mesh)
        : grid_(grid), level_(level), mesh_(mesh) {}

    std::string fault() {
        std::string why = oracle::malformed_mesh(mesh_, 3);
        if (why.empty()) why = bad_vertices();
        if (why.empty()) why = bad_triangles();
        if (why.empty()) why = bad_cells();
        if (why.empty()) why = gap();
        return why;
    }

private:
    int size(std::size_t axis) const {
        return axis == 0 ? grid_.nx : axis == 1 ? grid_.ny : grid_.nz;
    }
    double density(const Point& p) const {
        return grid_.density[static_cast<std::size_t>(
            (p[2] * grid_.ny + p[1]) * grid_.nx + p[0])];
    }
    bool is_inside(const Point& p) const { return density(p) > level_; }

    static std::array<Point, 2> ends(const Edge& edge) {
        Point low, high;
        for (std::size_t a = 0; a < 3; ++a) {
            low[a] = edge[a] / 2;
            high[a] = edge[a] - low[a];
        }
        return {low, high};
    }

    /// The edge that a position lies on; its other coordinates are whole.
    std::optional<Edge> edge_at(Vec3 p) const {
        const std::array<double, 3> at = {p.x, p.y, p.z};
        Edge edge;
        int between = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            if (!(at[a] > -0.5 && at[a] < size(a) - 0.5)) return std::nullopt;
            const int near = static_cast<int>(std::lround(at[a]));
            if (std::fabs(at[a] - near) <= 1e-9) {
                edge[a] = 2 * near;
            } else {
                edge[a] = 2 * static_cast<int>(std::floor(at[a])) + 1;
                ++between;
            }
            if (edge[a] < 0 || edge[a] > 2 * size(a) - 2) return std::nullopt;
        }
        return between == 1 ? std::optional(edge) : std::nullopt;
    }

    Vec3 crossing(const Edge& edge) const {
        const auto [low, high] = ends(edge);
        const double here = std::fabs(density(low) - level_);
        const double there = std::fabs(density(high) - level_);
        std::array<double, 3> at;
        for (std::size_t a = 0; a < 3; ++a)
            at[a] = (there * low[a] + here * high[a]) / (here + there);
        return {at[0], at[1], at[2]};
    }

    int count_crossings() const {
        if (std::min({grid_.nx, grid_.ny, grid_.nz}) < 2) return 0;
        int count = 0;
        Point p;
        for (p[2] = 0; p[2] < grid_.nz; ++p[2])
            for (p[1] = 0; p[1] < grid_.ny; ++p[1])
                for (p[0] = 0; p[0] < grid_.nx; ++p[0])
                    for (std::size_t a = 0; a < 3; ++a) {
                        Point next = p;
                        if (++next[a] < size(a))
                            count += is_inside(p) != is_inside(next);
                    }
        return count;
    }

    std::string bad_vertices() {
        std::set<Edge> taken;
        for (int v = 0; v < mesh_.vertex_count(); ++v) {
            const std::string name = "vertex " + std::to_string(v);
            const Vec3 at = mesh_.positions[static_cast<std::size_t>(v)];
            const auto edge = edge_at(at);
            if (!edge) return name + " is not on an edge of the grid";
            const auto [low, high] = ends(*edge);
            if (is_inside(low) == is_inside(high))
                return name + " is on an edge that is not crossed";
            if (!(length(at - crossing(*edge)) <= 1e-9))
                return name + " is not where the level is reached";
            if (!taken.insert(*edge).second)
                return name + " is on the edge of another one";
            edges_.push_back(*edge);
        }
        const int wanted = count_crossings();
        if (mesh_.vertex_count() == wanted) return "";
        return "has " + std::to_string(mesh_.vertex_count()) +
               " vertices for " + std::to_string(wanted) + " crossings";
    }

    const Edge& edge(int v) const {
        return edges_[static_cast<std::size_t>(v)];
    }

    /// The cell that has all three edges, which lie not all in one side of it.
    std::optional<Point> cell_of(FaceList::Face corners) const {
        Point cell;
        for (std::size_t a = 0; a < 3; ++a) {
            int low = edge(corners[0])[a], high = low;
            for (const int v : corners) {
                low = std::min(low, edge(v)[a]);
                high = std::max(high, edge(v)[a]);
            }
            if (low == high && low % 2 == 0) return std::nullopt;
            cell[a] = low / 2;
            if (high > 2 * cell[a] + 2) return std::nullopt;
        }
        return cell;
    }

    std::string bad_triangles() {
        for (int f = 0; f < mesh_.faces.size(); ++f) {
            const std::string name = "triangle " + std::to_string(f);
            const auto cell = cell_of(mesh_.faces[f]);
            if (!cell) return name + " is not in the inside of one cell";
            if (!(length(oracle::doubled_area(mesh_, mesh_.faces[f])) > 1e-9))
                return name + " has no area";
            triangles_[*cell].push_back(f);
        }
        return "";
    }

    using Sides = std::set<std::pair<int, int>>;

    /// The sides of the triangles without those that run both ways; nullopt
    /// when two run the same way.
    std::optional<Sides> open_sides(const std::vector<int>& faces) const {
        Sides all, open;
        for (const int f : faces)
            for (std::size_t k = 0; k < 3; ++k)
                if (!all.insert(
                            {mesh_.faces[f][k], mesh_.faces[f][(k + 1) % 3]})
                         .second)
                    return std::nullopt;
        for (const auto& [a, b] : all)
            if (!all.contains({b, a})) open.insert({a, b});
        return open;
    }

    /// In which direction the outline of a side of the cell, counter-clockwise
    /// seen from outside of the cell, passes through the surface at an edge:
    /// true when it comes from outside of the solid and goes in.
    bool goes_in(const Edge& crossed, std::size_t axis, bool far,
                 const Point& cell) const {
        const std::size_t along = axis_of(crossed);
        const std::size_t other = 3 - axis - along;
        // Seen from the tip of `axis`, u turns to v; at v low it runs along u.
        bool forward = along == (axis + 1) % 3;
        if (crossed[other] / 2 > cell[other]) forward = !forward;
        if (!far) forward = !forward;
        const auto [low, high] = ends(crossed);
        return is_inside(forward ? high : low);
    }

    /// In each side of the cell the open sides of its triangles must join the
    /// crossings, each once, from where the outline goes in to where it leaves.
    std::string bad_cell(const Point& cell, const Sides& open) const {
        std::size_t joined = 0, crossings = 0;
        std::set<int> used;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const bool far : {false, true}) {
                used.clear();
                const int plane = 2 * (cell[axis] + (far ? 1 : 0));
                for (const auto& [a, b] : open) {
                    if (edge(a)[axis] != plane || edge(b)[axis] != plane)
                        continue;
                    if (!goes_in(edge(a), axis, far, cell) ||
                        goes_in(edge(b), axis, far, cell))
                        return "a triangle looks inwards";
                    if (!used.insert(a).second || !used.insert(b).second)
                        return "a crossing is joined twice";
                    ++joined;
                }
                crossings += crossings_in(cell, axis, plane);
            }
        if (joined != open.size()) return "a triangle is open inside the cell";
        if (2 * joined != crossings) return "a crossing is not joined";
        return "";
    }

    std::size_t crossings_in(const Point& cell, std::size_t axis,
                             int plane) const {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::size_t count = 0;
        for (const auto& [du, dv] : {std::pair{1, 0}, {1, 2}, {0, 1}, {2, 1}}) {
            Edge e;
            e[axis] = plane;
            e[u] = 2 * cell[u] + du;
            e[v] = 2 * cell[v] + dv;
            const auto [low, high] = ends(e);
            if (is_inside(low) != is_inside(high)) ++count;
        }
        return count;
    }

    std::string bad_cells() const {
        Point cell;
        for (cell[2] = 0; cell[2] + 1 < grid_.nz; ++cell[2])
            for (cell[1] = 0; cell[1] + 1 < grid_.ny; ++cell[1])
                for (cell[0] = 0; cell[0] + 1 < grid_.nx; ++cell[0]) {
                    const auto found = triangles_.find(cell);
                    const auto open = open_sides(found == triangles_.end()
                                                     ? std::vector<int>{}
                                                     : found->second);
                    std::string why = "two triangles run the same way";
                    if (open) why = bad_cell(cell, *open);
                    if (!why.empty())
                        return "in the cell " + show(cell) + " " + why;
                }
        return "";
    }

    bool in_rim(int a, int b) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int plane : {0, 2 * size(axis) - 2})
                if (edge(a)[axis] == plane && edge(b)[axis] == plane)
                    return true;
        return false;
    }

    std::string gap() const {
        std::vector<int> all;
        for (int f = 0; f < mesh_.faces.size(); ++f) all.push_back(f);
        const auto open = open_sides(all);
        if (!open) return "two triangles run along a side the same way";
        for (const auto& [a, b] : *open)
            if (!in_rim(a, b))
                return "only one triangle runs along " + std::to_string(a) +
                       "->" + std::to_string(b) + ", inside the grid";
        return "";
    }

    const DensityGrid& grid_;
    double level_;
    const IndexedMesh& mesh_;
    std::vector<Edge> edges_;  // of the vertices
    std::map<Point, std::vector<int>> triangles_;
};

oracle::FaultMatcher<IndexedMesh> IsSurfaceOf(const DensityGrid& grid,
                                              double level) {
    return {"the surface at the level " + show(level),
            [=](const IndexedMesh& mesh) {
                return Check(grid, level, mesh).fault();
            }};
}

void check(const DensityGrid& grid, double level) {
    REQUIRE_THAT(marching_cubes(grid, level), IsSurfaceOf(grid, level));
}

class Random {
public:
    explicit Random(std::uint64_t salt) : next_(seed() * 1000 + salt) {}

    /// Between a and b.
    double between(double a, double b) {
        return a + (b - a) * static_cast<double>(next_() >> 11) / 0x1p53;
    }
    /// A density well away from the level.
    double density(double level, bool inside) {
        return level + (inside ? 1 : -1) * between(0.2, 1);
    }
    bool one_in_two() { return next_() % 2 == 0; }

private:
    std::mt19937_64 next_;
};

/// One cell with the corners of a case inside.
DensityGrid one_cell(unsigned inside, double level, Random& random) {
    DensityGrid grid{2, 2, 2, {}};
    for (unsigned c = 0; c < 8; ++c)
        grid.density.push_back(random.density(level, (inside >> c & 1) != 0));
    return grid;
}

bool is_rim(int i, int n) {
    return i == 0 || i == n - 1;
}

DensityGrid random_grid(int nx, int ny, int nz, double level, bool closed,
                        Random& random) {
    DensityGrid grid{nx, ny, nz, {}};
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const bool rim =
                    is_rim(x, nx) || is_rim(y, ny) || is_rim(z, nz);
                const bool inside = random.one_in_two() && !(closed && rim);
                grid.density.push_back(random.density(level, inside));
            }
    return grid;
}

/// The density of a formula, kept away from the level 0.
template <class Formula>
DensityGrid sampled(int n, Formula formula) {
    DensityGrid grid{n, n, n, {}};
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double d = formula(Vec3{1.0 * x, 1.0 * y, 1.0 * z});
                grid.density.push_back(std::fabs(d) > 0.01 ? d
                                       : d > 0             ? 0.01
                                                           : -0.01);
            }
    return grid;
}

}  // namespace

TEST_CASE("one corner of a cell inside, or all but one", "[points:1]") {
    hint("Which bit stands for which corner, and where does an edge begin?");
    Random random(1);
    for (unsigned c = 0; c < 8; ++c) {
        check(one_cell(1u << c, 0, random), 0);
        check(one_cell(255u - (1u << c), 0, random), 0);
    }
}

TEST_CASE("every case of a cell", "[points:2]") {
    hint(
        "How many triangles can a row of the table hold, and where does it "
        "end?");
    Random random(2);
    for (unsigned inside = 0; inside < 256; ++inside)
        check(one_cell(inside, 0, random), 0);
}

TEST_CASE("at other levels than 0", "[points:1]") {
    hint(
        "Where do you compare with the level, and where do you compute with "
        "it?");
    Random random(3);
    for (const double level : {3.0, -2.5, 0.125, 1000.0})
        for (unsigned inside = 0; inside < 256; inside += 5)
            check(one_cell(inside, level, random), level);
    check(one_cell(0x17, 0.5, random), 0.5);
}

TEST_CASE("cells that share edges share their vertices", "[points:2]") {
    hint("What names an edge of the grid, whichever cell it is seen from?");
    Random random(4);
    for (int k = 0; k < 40; ++k) {
        check(random_grid(3, 2, 2, 0, false, random), 0);
        check(random_grid(2, 3, 2, 0, false, random), 0);
        check(random_grid(2, 2, 3, 0, false, random), 0);
    }
    check(random_grid(3, 3, 3, 1, false, random), 1);
}

TEST_CASE("grids with different sizes", "[points:1]") {
    hint("Where in the list is the point (i, j, k)?");
    Random random(5);
    check(random_grid(5, 3, 2, 0, false, random), 0);
    check(random_grid(2, 6, 4, 2, false, random), 2);
    check(random_grid(3, 2, 7, -1, false, random), -1);
}

TEST_CASE("closed where the solid is not at the rim", "[points:2]") {
    hint(
        "Look at two cells with a side in common. Do they join the same "
        "points?");
    Random random(6);
    for (int k = 0; k < 12; ++k) {
        const DensityGrid grid = random_grid(5, 6, 5, 0, true, random);
        const IndexedMesh mesh = marching_cubes(grid, 0);
        REQUIRE_THAT(mesh, IsSurfaceOf(grid, 0));
        REQUIRE(oracle::open_side(mesh.faces) == "");
        REQUIRE(oracle::enclosed_volume(mesh) > 0);
    }
}

TEST_CASE("a ball and a ring", "[points:2]") {
    hint("Which side of the surface is the outside, the lower density?");
    const double r = 6.3;
    const DensityGrid ball = sampled(17, [&](Vec3 p) {
        return r - length(p - Vec3{8.1, 7.9, 8.02});
    });
    const IndexedMesh sphere = marching_cubes(ball, 0);
    REQUIRE_THAT(sphere, IsSurfaceOf(ball, 0));
    const double full = 4 * std::numbers::pi / 3 * r * r * r;
    const double part = oracle::enclosed_volume(sphere) / full;
    CHECK(part > 0.97);
    CHECK(part < 1.0);
    CHECK(2 * (sphere.vertex_count() - 2) == sphere.faces.size());
    const DensityGrid ring = sampled(15, [](Vec3 p) {
        const Vec3 q = p - Vec3{7.03, 6.98, 7.1};
        return 2.1 - std::hypot(std::hypot(q.x, q.y) - 4.2, q.z);
    });
    const IndexedMesh torus = marching_cubes(ring, 0);
    REQUIRE_THAT(torus, IsSurfaceOf(ring, 0));
    CHECK(2 * torus.vertex_count() == torus.faces.size());
}

TEST_CASE("all inside, all outside, and grids without cells", "[points:1]") {
    hint("How many cells are there in a grid that is one point thick?");
    Random random(7);
    check(one_cell(0x3c, 0, random), 0);
    check(one_cell(0, 0, random), 0);
    check(one_cell(255, 0, random), 0);
    for (const auto& [nx, ny, nz] : {Point{1, 1, 1},
                                     {1, 4, 4},
                                     {4, 1, 4},
                                     {4, 4, 1},
                                     {5, 1, 1},
                                     {0, 0, 0},
                                     {0, 3, 3},
                                     {3, 3, 0}})
        check(random_grid(nx, ny, nz, 0, false, random), 0);
}

TEST_CASE("sizes that do not fit are refused", "[points:1]") {
    hint("Which three numbers are no sizes of a grid?");
    const std::vector<double> eight = {1, -1, 1, -1, 1, 1, -1, -1};
    for (const DensityGrid& grid :
         {DensityGrid{2, 2, 2, {}}, DensityGrid{2, 2, 3, eight},
          DensityGrid{2, 2, 1, eight}, DensityGrid{-2, -2, 2, eight},
          DensityGrid{-1, 8, -1, eight}, DensityGrid{2, -4, -1, eight},
          DensityGrid{0, 2, 2, eight}, DensityGrid{-1, 0, 0, {}},
          DensityGrid{0, -3, 0, {}}, DensityGrid{0, 0, -1, {}}})
        CHECK_THROWS_AS(marching_cubes(grid, 0), std::invalid_argument);
}

TEST_CASE("the cost grows no faster than the grid", "[points:1][once]") {
    hint("How do you find the vertex of an edge that another cell has made?");
    Random random(8);
    for (int k = 0; k < 5; ++k)
        check(random_grid(11, 11, 11, 0, false, random), 0);
}
