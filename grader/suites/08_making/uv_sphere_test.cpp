// Hidden suite of uv_sphere: any numbering and any diagonals pass.
#include "exercises/08_making/uv_sphere.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

/// A point of the globe: circle j, meridian i; i is 0 at the poles.
using Place = std::pair<int, int>;

Vec3 position(Place place, int nu, int nv) {
    const auto [j, i] = place;
    if (j == 0 || j == nv) return {0, 0, j == 0 ? 1.0 : -1.0};
    const double up = std::numbers::pi * (0.5 - 1.0 * j / nv);
    const double round = 2 * std::numbers::pi * i / nu;
    return {std::cos(up) * std::cos(round), std::cos(up) * std::sin(round),
            std::sin(up)};
}

/// Where each vertex should be, by where it nearly is.
std::vector<Place> places(const IndexedMesh& mesh, int nu, int nv) {
    std::vector<Place> places;
    for (const Vec3 p : mesh.positions) {
        const double down = std::atan2(std::hypot(p.x, p.y), p.z);
        const double round = std::atan2(p.y, p.x);
        const int j =
            static_cast<int>(std::lround(down / std::numbers::pi * nv));
        const int i =
            static_cast<int>(std::lround(round / std::numbers::pi / 2 * nu));
        const bool is_pole = j == 0 || j == nv;
        places.push_back({j, is_pole ? 0 : (i + nu) % nu});
    }
    return places;
}

std::string bad_vertices(const IndexedMesh& mesh, int nu, int nv) {
    if (mesh.vertex_count() != 2 + nu * (nv - 1))
        return "has " + std::to_string(mesh.vertex_count()) +
               " vertices, not 2 + nu (nv - 1)";
    const std::vector<Place> found = places(mesh, nu, nv);
    std::set<Place> taken;
    for (std::size_t v = 0; v < found.size(); ++v) {
        const std::string name = "vertex " + std::to_string(v);
        const Vec3 wanted = position(found[v], nu, nv);
        if (!(length(mesh.positions[v] - wanted) <= 1e-9))
            return name + " is on no crossing of the grid, and no pole";
        if (!taken.insert(found[v]).second)
            return name + " is in the place of another one";
    }
    return "";
}

/// The cell (band, meridian) that has the three corners, if there is one.
std::optional<Place> cell(const std::vector<Place>& corners, int nu, int nv) {
    std::set<int> circles, meridians;
    for (const auto& [j, i] : corners) {
        circles.insert(j);
        if (j != 0 && j != nv) meridians.insert(i);
    }
    if (circles.size() != 2 || meridians.size() != 2) return std::nullopt;
    const int top = *circles.begin(), bottom = *circles.rbegin();
    const int west = *meridians.begin(), east = *meridians.rbegin();
    if (bottom != top + 1) return std::nullopt;
    if (east == west + 1) return Place{top, west};
    if (west == 0 && east == nu - 1) return Place{top, east};
    return std::nullopt;
}

/// Each cell must have its number of triangles, each triangle its cell.
std::string bad_faces(const IndexedMesh& mesh, int nu, int nv) {
    if (mesh.faces.size() != 2 * nu * (nv - 1))
        return "has " + std::to_string(mesh.faces.size()) +
               " triangles, not 2 nu (nv - 1)";
    const std::vector<Place> found = places(mesh, nu, nv);
    std::map<Place, int> triangles;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::string name = "triangle " + std::to_string(f);
        std::vector<Place> corners;
        Vec3 sum;
        for (const int v : mesh.faces[f]) {
            corners.push_back(found[static_cast<std::size_t>(v)]);
            sum = sum + mesh.positions[static_cast<std::size_t>(v)];
        }
        const auto in = cell(corners, nu, nv);
        if (!in) return name + " is in no cell of the grid";
        const bool at_pole = in->first == 0 || in->first == nv - 1;
        if (++triangles[*in] > (at_pole ? 1 : 2))
            return name + " is one too many for its cell";
        if (!(dot(oracle::doubled_area(mesh, mesh.faces[f]), sum) > 0))
            return name + " looks inwards";
    }
    return oracle::open_side(mesh.faces);
}

oracle::FaultMatcher<IndexedMesh> IsGlobe(int nu, int nv) {
    return {"the sphere of this grid", [=](const IndexedMesh& mesh) {
                std::string why = oracle::malformed_mesh(mesh, 3);
                if (why.empty()) why = bad_vertices(mesh, nu, nv);
                if (why.empty()) why = bad_faces(mesh, nu, nv);
                return why;
            }};
}

oracle::FaultMatcher<IndexedMesh> HasItsVertices(int nu, int nv) {
    return {"a mesh with the vertices of this grid",
            [=](const IndexedMesh& mesh) {
                const std::string why = oracle::malformed_mesh(mesh, 3);
                return why.empty() ? bad_vertices(mesh, nu, nv) : why;
            }};
}

}  // namespace

TEST_CASE("the vertices lie on the sphere, each place once", "[points:2]") {
    hint("How often does the pole occur, and the first meridian?");
    for (const auto& [nu, nv] : {Place{4, 3}, {8, 4}, {5, 6}, {7, 2}})
        CHECK_THAT(uv_sphere(nu, nv), HasItsVertices(nu, nv));
}

TEST_CASE("the middle bands", "[points:2]") {
    hint(
        "Which four crossings are the corners of a cell, and which way round?");
    for (const auto& [nu, nv] : {Place{8, 4}, {5, 6}, {12, 9}, {4, 3}, {9, 8}})
        CHECK_THAT(uv_sphere(nu, nv), IsGlobe(nu, nv));
}

TEST_CASE("two bands only: all triangles end at a pole", "[points:1]") {
    hint("Is a triangle at the south pole wound like one at the north pole?");
    for (const int nu : {4, 5, 12})
        CHECK_THAT(uv_sphere(nu, 2), IsGlobe(nu, 2));
}

TEST_CASE("three meridians, the fewest", "[points:1]") {
    hint("Which meridian comes after the last one?");
    for (const int nv : {2, 3, 4, 7})
        CHECK_THAT(uv_sphere(3, nv), IsGlobe(3, nv));
}

TEST_CASE("the volume comes near to that of the sphere", "[points:1]") {
    hint("Is the surface closed, and on which side is the inside?");
    const IndexedMesh mesh = uv_sphere(48, 24);
    REQUIRE(oracle::malformed_mesh(mesh, 3) == "");
    CHECK(oracle::open_side(mesh.faces) == "");
    const double volume = oracle::enclosed_volume(mesh);
    CHECK(volume > 4.13);
    CHECK(volume < 4 * std::numbers::pi / 3);
}

TEST_CASE("all small grids", "[points:1]") {
    hint("Try a few numbers of meridians and bands on paper.");
    for (int nu = 3; nu < 12; ++nu)
        for (int nv = 2; nv < 12; ++nv)
            REQUIRE_THAT(uv_sphere(nu, nv), IsGlobe(nu, nv));
}

TEST_CASE("too few meridians or bands are refused", "[points:1]") {
    hint("Which is the smallest grid that gives a closed surface?");
    for (const auto& [nu, nv] : {Place{2, 2},
                                 {2, 5},
                                 {0, 3},
                                 {-3, 4},
                                 {3, 1},
                                 {8, 1},
                                 {5, 0},
                                 {5, -2},
                                 {1, 1},
                                 {-3, -3}})
        CHECK_THROWS_AS(uv_sphere(nu, nv), std::invalid_argument);
}

TEST_CASE("the cost grows no faster than the mesh", "[points:1][once]") {
    hint("Do you search for a vertex whose number you could work out?");
    REQUIRE_THAT(uv_sphere(70, 60), IsGlobe(70, 60));
}
