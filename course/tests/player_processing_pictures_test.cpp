// The data of the pictures that are made by references, against counts and
// formulas that do not use them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "course/halfedge/build.h"
#include "course/player/pictures/cubes_picture.h"
#include "course/player/pictures/lod_picture.h"
#include "course/player/pictures/normals_picture.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/pictures/shapes.h"
#include "course/player/pictures/simplification_picture.h"
#include "course/player/pictures/smoothing_picture.h"
#include "course/player/reference.h"
#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/tests/mesh_counts.h"
#include "exercises/09_processing/smooth.h"

using namespace course;

namespace {

bool is_closed(const IndexedMesh& mesh) {
    for (const auto& [edge, faces] : brute::edges_of(mesh))
        if (faces != 2) return false;
    return true;
}

bool is_near(double a, double b, double by = 1e-9) {
    return std::abs(a - b) <= by;
}

/// Corners of faces by place: meshes of single cells share no vertices.
std::multiset<std::vector<double>> triangles_of(const IndexedMesh& mesh) {
    std::multiset<std::vector<double>> all;
    for (const FaceList::Face face : mesh.faces) {
        std::vector<std::vector<double>> corners;
        for (const int v : face) {
            const Vec3 p = mesh.positions[brute::at(v)];
            corners.push_back({std::round(p.x * 1e6), std::round(p.y * 1e6),
                               std::round(p.z * 1e6)});
        }
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
        std::vector<double> flat;
        for (const auto& corner : corners)
            flat.insert(flat.end(), corner.begin(), corner.end());
        all.insert(flat);
    }
    return all;
}

}  // namespace

TEST_CASE("the shapes of the pictures are closed, and wound outwards") {
    for (const IndexedMesh& mesh : {pawn(), brick(), noisy_sphere()}) {
        CHECK(is_closed(mesh));
        CHECK(brute::euler_of(mesh) == 2);
        CHECK(brute::six_volumes(mesh) > 0);
        CHECK_NOTHROW(build(mesh));
    }
    CHECK(brute::six_volumes(brick()) / 6 > 1.6);
    CHECK(pawn().faces.size() == 480);
    CHECK(brick().faces.size() == 320);
}

TEST_CASE("faces with gaps in their numbers are found once each") {
    IndexedMesh mesh = brick();
    std::vector<HalfEdge> rows = build(mesh).rows();
    for (HalfEdge& row : rows)
        if (row.fi != -1) row.fi = 3 * row.fi + 5;
    const IndexedMesh again{
        mesh.positions, faces_left(HalfEdgeTable(rows)), {}};
    CHECK(triangles_of(again) == triangles_of(mesh));
}

TEST_CASE("a page has all that a picture is made of") {
    for (const Picture& picture : pictures_of_references()) {
        INFO(picture.name);
        CHECK(std::filesystem::exists(source_root() / "course/lectures" /
                                      (picture.chapter + ".md")));
        CHECK(std::filesystem::exists(source_root() /
                                      "course/player/page/pictures" /
                                      (picture.name + ".js")));
    }
    const auto all = lecture_pictures();
    CHECK(std::any_of(all.begin(), all.end(), [](const Picture& picture) {
              return picture.name == "lod";
          }) == has_solutions());
}

// What follows runs references; a student's copy has none.

TEST_CASE("the three normals are the weighted means of what is shown") {
    if (!has_solutions()) return;
    for (const Cut cut : {Cut::first, Cut::second}) {
        const WeighedCorner corner = weighed_corner(cut);
        Vec3 sums[3];
        double angles = 0, area = 0;
        for (const WeighedTriangle& t : corner.triangles) {
            sums[0] = sums[0] + t.normal;
            sums[1] = sums[1] + t.area * t.normal;
            sums[2] = sums[2] + t.angle * t.normal;
            angles += t.angle;
            area += t.area;
        }
        // Sides of 2, 3 and 6, each whole or half of it at the corner.
        CHECK(is_near(area, cut == Cut::first ? 2 + 1.5 + 6 : 2 + 3 + 3));
        for (std::size_t w = 0; w < 3; ++w)
            CHECK(is_near(dot(sums[w], corner.normals[w]), length(sums[w])));
        // Three right angles, however they are cut.
        CHECK(is_near(angles, 1.5 * std::numbers::pi));
        CHECK(is_near(corner.normals[2].x, 1 / std::sqrt(3.0)));
        CHECK(is_near(corner.normals[2].y, corner.normals[2].z));
    }
    CHECK(weighed_corner(Cut::first).triangles.size() == 7);
    CHECK(weighed_corner(Cut::second).triangles.size() == 5);
}

TEST_CASE(
    "each step of smoothing puts vertices between themselves and the "
    "mean of their neighbours") {
    if (!has_solutions()) return;
    const auto steps = smoothed_ball(1, 0.5, -0.53);
    REQUIRE(steps.size() == 3);
    const IndexedMesh mesh = noisy_sphere();
    std::vector<std::set<int>> neighbours(mesh.positions.size());
    for (const auto& [edge, faces] : brute::edges_of(mesh)) {
        neighbours[brute::at(edge.first)].insert(edge.second);
        neighbours[brute::at(edge.second)].insert(edge.first);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& from = steps[k].positions;
        const double w = k == 0 ? 0.5 : -0.53;
        for (std::size_t v = 0; v < from.size(); ++v) {
            Vec3 mean;
            for (const int n : neighbours[v])
                mean = mean + (1.0 / double(neighbours[v].size())) *
                                  from[brute::at(n)];
            const Vec3 there = from[v] + w * (mean - from[v]);
            CHECK(length(there - steps[k + 1].positions[v]) < 1e-9);
        }
    }
    for (const Smoothed& step : steps) {
        const IndexedMesh now{step.positions, mesh.faces, {}};
        CHECK(is_near(step.volume, brute::six_volumes(now) / 6));
    }
    CHECK(steps[1].bumps < steps[0].bumps);
}

TEST_CASE(
    "clustering and collapse leave the same number of triangles, and "
    "only collapse stays closed") {
    if (!has_solutions()) return;
    const auto ways = simplified(brick(), {0.35, 0.5});
    for (const TwoWays& way : ways) {
        const auto faces = way.collapsed.mesh.faces.size();
        CHECK(std::abs(faces - way.clustered.mesh.faces.size()) <= 1);
        CHECK(is_closed(way.collapsed.mesh));
        CHECK(way.collapsed.bad_edges.empty());
        CHECK(way.collapsed.error < 1e-9);
        CHECK(way.clustered.error > 0.1);
        // A vertex moves by less than the diagonal of its cube.
        CHECK(way.clustered.error < way.cell * std::sqrt(3.0));
        std::vector<std::array<int, 3>> bad;
        for (const auto& [edge, n] : brute::edges_of(way.clustered.mesh))
            if (n > 2) bad.push_back({edge.first, edge.second, n});
        CHECK(way.clustered.bad_edges == bad);
        // The page says so.
        for (const auto& edge : bad) CHECK(edge[2] == 4);
    }
    CHECK(!ways[1].clustered.bad_edges.empty());
}

TEST_CASE("each level of detail has half of the faces, and its own edges") {
    if (!has_solutions()) return;
    const IndexedMesh mesh = pawn();
    const auto levels = levels_of(mesh, 4);
    REQUIRE(levels.size() == 4);
    const auto mean_edge = [&](const FaceList& faces) {
        double sum = 0;
        const auto edges = brute::edges_of({mesh.positions, faces, {}});
        for (const auto& [edge, n] : edges)
            sum += length(mesh.positions[brute::at(edge.first)] -
                          mesh.positions[brute::at(edge.second)]);
        return sum / double(edges.size());
    };
    for (std::size_t l = 0; l < levels.size(); ++l) {
        CHECK(levels[l].faces.size() == 480 >> l);
        CHECK(is_closed({mesh.positions, levels[l].faces, {}}));
        CHECK(is_near(levels[l].from,
                      mean_edge(levels[l].faces) / mean_edge(mesh.faces)));
    }
}

TEST_CASE("the cells of marching cubes make up the surface of the whole") {
    if (!has_solutions()) return;
    const MarchingCubes march("marching_cubes");
    const DensityGrid grid = blob();
    std::multiset<std::vector<double>> of_cells;
    for (const MarchedCell& cell : marched_cells(grid, 1, march)) {
        CHECK(cell.number > 0);
        CHECK(cell.number < 255);
        of_cells.merge(triangles_of(cell.mesh));
    }
    const IndexedMesh whole = march(grid, 1);
    CHECK(of_cells == triangles_of(whole));
    CHECK(is_closed(whole));
}

TEST_CASE("two cells cut their common side along the same two lines") {
    if (!has_solutions()) return;
    const MarchingCubes march("marching_cubes");
    const auto cells = marched_cells(two_cells(), 1, march);
    REQUIRE(cells.size() == 2);
    CHECK(cells[0].number == 2 + 128);
    CHECK(cells[1].number == 1 + 64);
    const IndexedMesh whole = march(two_cells(), 1);
    int shared = 0;
    for (const auto& [edge, faces] : brute::edges_of(whole)) {
        const bool at_side = whole.positions[brute::at(edge.first)].x == 1 &&
                             whole.positions[brute::at(edge.second)].x == 1;
        if (!at_side) continue;
        CHECK(faces == 2);
        ++shared;
    }
    CHECK(shared == 2);
}

TEST_CASE("what a reference throws is thrown here") {
    if (!has_solutions()) return;
    const Reference<decltype(smooth)> smooth_by_reference("smooth");
    const IndexedMesh mesh = brick();
    CHECK_THROWS_AS(smooth_by_reference(build(mesh), mesh.positions, -1, 0.5),
                    std::invalid_argument);
    CHECK(smooth_by_reference(build(mesh), mesh.positions, 0, 0.5) ==
          mesh.positions);
}
