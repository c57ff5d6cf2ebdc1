// The generators: sound tables, Euler's formula, and the same faces every time.
#include "course/mesh/generators.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_counts.h"

namespace {

using namespace course;
using namespace course::brute;

std::map<int, int> degrees(const IndexedMesh& mesh) {
    std::map<int, int> count;
    for (const auto& face : mesh.faces) ++count[static_cast<int>(face.size())];
    return count;
}

int border_edges(const IndexedMesh& mesh) {
    int n = 0;
    for (const auto& [edge, faces] : edges_of(mesh)) n += faces == 1;
    return n;
}

/// A number that depends on every corner and on the order of the faces.
std::uint64_t fingerprint(const IndexedMesh& mesh) {
    std::uint64_t sum = static_cast<std::uint64_t>(mesh.vertex_count());
    for (const auto& face : mesh.faces) {
        sum = sum * 1'000'003 + face.size();
        for (const int v : face)
            sum = sum * 1'000'003 + static_cast<std::uint64_t>(v);
    }
    return sum;
}

/// 2S - chi - loops: twice the genus, summed over the components.
int twice_the_genus(const IndexedMesh& mesh) {
    return 2 * static_cast<int>(components_of(mesh).size()) - euler_of(mesh) -
           border_circles_of(mesh);
}

bool is_near(double value, double expected, double relative) {
    return std::abs(value - expected) <= relative * std::abs(expected);
}

RandomMesh options_of(int k) {
    RandomMesh options;
    options.faces = 1 + k * k;
    options.parts = 1 + k % std::min(4, options.faces);
    options.max_sides = 4 + k % 9;
    options.merge_percent = k * 37 % 101;
    options.hole_percent = k * 13 % 41;
    options.surface = static_cast<Surface>(k % 3);
    return options;
}

}  // namespace

TEST_CASE("an icosphere has its counts and lies on the unit sphere") {
    for (int levels = 0, quarter = 1; levels <= 4; ++levels, quarter *= 4) {
        const IndexedMesh mesh = icosphere(levels);
        CAPTURE(levels);
        CHECK(mesh.vertex_count() == 10 * quarter + 2);
        CHECK(mesh.faces.size() == 20 * quarter);
        CHECK(euler_of(mesh) == 2);
        CHECK(border_edges(mesh) == 0);
        CHECK(components_of(mesh).size() == 1);
        CHECK(validate(build(mesh)).empty());
        for (const Vec3& p : mesh.positions)
            CHECK(is_near(length(p), 1, 1e-12));
    }
    const double sphere = 4 * std::numbers::pi / 3;
    CHECK(is_near(six_volumes(icosphere(4)) / 6, sphere, 0.01));
}

TEST_CASE("an icosphere's triangles are nearly alike") {
    const IndexedMesh mesh = icosphere(3);
    double least = 1e9;
    double most = 0;
    for (const auto& [edge, faces] : edges_of(mesh)) {
        const double l = length(mesh.positions[at(edge.first)] -
                                mesh.positions[at(edge.second)]);
        least = std::min(least, l);
        most = std::max(most, l);
    }
    CHECK(most < 1.3 * least);
}

TEST_CASE("a torus of quads or triangles has its counts and genus 1") {
    for (const auto& [nu, nv] : {std::pair{3, 3}, {3, 5}, {7, 4}, {20, 10}}) {
        CAPTURE(nu, nv);
        const IndexedMesh quads = torus(nu, nv);
        const IndexedMesh triangles = torus(nu, nv, Cells::triangles);
        CHECK(quads.vertex_count() == nu * nv);
        CHECK(degrees(quads) == std::map<int, int>{{4, nu * nv}});
        CHECK(degrees(triangles) == std::map<int, int>{{3, 2 * nu * nv}});
        for (const IndexedMesh& mesh : {quads, triangles}) {
            CHECK(euler_of(mesh) == 0);
            CHECK(border_edges(mesh) == 0);
            CHECK(components_of(mesh).size() == 1);
            CHECK(validate(build(mesh)).empty());
            CHECK(six_volumes(mesh) > 0);
        }
    }
    const double volume = 4 * std::numbers::pi * std::numbers::pi;
    CHECK(is_near(six_volumes(torus(200, 100)) / 6, volume, 0.01));
}

TEST_CASE("a grid of quads or triangles has its counts and one border") {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 4}, {5, 2}, {12, 9}}) {
        CAPTURE(nx, ny);
        const IndexedMesh quads = grid(nx, ny);
        const IndexedMesh triangles = grid(nx, ny, Cells::triangles);
        CHECK(quads.vertex_count() == (nx + 1) * (ny + 1));
        CHECK(degrees(quads) == std::map<int, int>{{4, nx * ny}});
        CHECK(degrees(triangles) == std::map<int, int>{{3, 2 * nx * ny}});
        for (const IndexedMesh& mesh : {quads, triangles}) {
            CHECK(euler_of(mesh) == 1);
            const HalfEdgeTable he = build(mesh);
            CHECK(validate(he).empty());
            CHECK(loops_of(he) == std::vector<int>{2 * (nx + ny)});
        }
    }
    const IndexedMesh two = grid(2, 1);
    CHECK(two.positions[5] == Vec3{2, 1, 0});
    CHECK(two.faces == FaceList{{0, 1, 4, 3}, {1, 2, 5, 4}});
}

TEST_CASE("the regular meshes refuse sizes that make no mesh") {
    CHECK_THROWS_AS(icosphere(-1), std::invalid_argument);
    CHECK_THROWS_AS(icosphere(11), std::invalid_argument);
    CHECK_THROWS_AS(torus(2, 3), std::invalid_argument);
    CHECK_THROWS_AS(torus(3, 2), std::invalid_argument);
    CHECK_THROWS_AS(grid(0, 1), std::invalid_argument);
    CHECK_THROWS_AS(grid(1, 0), std::invalid_argument);
    CHECK_THROWS_AS(grid(50'000, 50'000), std::invalid_argument);
}

TEST_CASE("random meshes of all kinds have sound tables") {
    for (int k = 0; k < 60; ++k) {
        RandomMesh options = options_of(k);
        CAPTURE(k);
        for (const BowTies bow_ties : {BowTies::none, BowTies::allowed}) {
            options.bow_ties = bow_ties;
            const IndexedMesh mesh =
                random_polygons(static_cast<std::uint64_t>(k), options);
            const HalfEdgeTable he = build(mesh);
            CHECK(validate(he).empty());
            CHECK(to_faces(he).size() == mesh.faces.size());
            CHECK(mesh.faces.size() >= options.parts);
            CHECK(vertices_of(mesh) == mesh.vertex_count());
            if (bow_ties == BowTies::none)
                CHECK(bow_tie_vertices(mesh).empty());
        }
    }
}

TEST_CASE("random meshes fulfil Euler's formula with a whole genus") {
    int tori = 0;
    for (int k = 0; k < 60; ++k) {
        CAPTURE(k);
        const IndexedMesh mesh =
            random_polygons(static_cast<std::uint64_t>(k), options_of(k));
        const int twice = twice_the_genus(mesh);
        CHECK(twice >= 0);
        CHECK(twice % 2 == 0);
        CHECK(static_cast<std::size_t>(border_circles_of(mesh)) ==
              loops_of(build(mesh)).size());
        tori += twice / 2;
    }
    CHECK(tori > 10);
}

TEST_CASE("random meshes have triangles, and faces of as many sides as asked") {
    std::map<int, int> all;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomMesh options;
        options.faces = 400;
        options.max_sides = 9;
        for (const auto& [sides, n] : degrees(random_polygons(seed, options)))
            all[sides] += n;
    }
    CHECK(all.begin()->first == 3);
    CHECK(all.rbegin()->first == 9);
    CHECK(all.size() == 7);
}

TEST_CASE("random meshes are open or closed as asked") {
    RandomMesh options;
    options.parts = 5;
    options.faces = 300;
    int closed_parts = 0;
    int open_parts = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        options.surface = Surface::closed;
        CHECK(border_edges(random_polygons(seed, options)) == 0);
        options.surface = Surface::open;
        options.hole_percent = 0;
        const IndexedMesh open = random_polygons(seed, options);
        CHECK(components_of(open).size() == 5);
        CHECK(border_circles_of(open) == 5);
        options.surface = Surface::plane;
        const IndexedMesh plane = random_polygons(seed, options);
        CHECK(border_circles_of(plane) == 5);
        for (const Vec3& position : plane.positions) CHECK(position.z == 0);
        options.surface = Surface::mixed;
        const IndexedMesh mixed = random_polygons(seed, options);
        open_parts += border_circles_of(mixed);
        closed_parts += 5 - border_circles_of(mixed);
    }
    CHECK(open_parts > 20);
    CHECK(closed_parts > 20);
}

TEST_CASE("holes appear, and bow-ties only where they are allowed") {
    RandomMesh options;
    options.faces = 500;
    options.hole_percent = 20;
    std::size_t holes = 0;
    std::size_t bow_ties = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        options.bow_ties = BowTies::none;
        const IndexedMesh mesh = random_polygons(seed, options);
        CHECK(bow_tie_vertices(mesh).empty());
        holes += loops_of(build(mesh)).size() - 1;
        options.bow_ties = BowTies::allowed;
        bow_ties += bow_tie_vertices(random_polygons(seed, options)).size();
    }
    CHECK(holes > 100);
    CHECK(bow_ties > 100);
}

TEST_CASE("no part vanishes when every face is to be taken out") {
    RandomMesh options;
    options.parts = 3;
    options.hole_percent = 100;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        options.bow_ties = BowTies::allowed;
        CHECK(random_polygons(seed, options).faces.size() == 3);
        options.bow_ties = BowTies::none;
        CHECK(random_polygons(seed, options).faces.size() >= 3);
    }
}

TEST_CASE("unused vertices are dropped, or stay as gaps in the numbers") {
    RandomMesh options;
    options.hole_percent = 60;
    options.bow_ties = BowTies::allowed;
    int gaps = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        options.unused = Unused::dropped;
        const IndexedMesh dropped = random_polygons(seed, options);
        CHECK(vertices_of(dropped) == dropped.vertex_count());
        options.unused = Unused::kept;
        const IndexedMesh kept = random_polygons(seed, options);
        CHECK(vertices_of(kept) == dropped.vertex_count());
        CHECK(kept.faces.size() == dropped.faces.size());
        gaps += kept.vertex_count() - dropped.vertex_count();
    }
    CHECK(gaps > 100);
}

TEST_CASE(
    "two faces of a random mesh may share edges that are not neighbours") {
    RandomMesh options;
    options.faces = 400;
    options.merge_percent = 100;
    options.max_sides = 20;
    int apart = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const HalfEdgeTable he = build(random_polygons(seed, options));
        for (int i = 0; i < he.size(); ++i) {
            const int other = he[he[i].opp].fi;
            const int next = he[he[he[i].next].opp].fi;
            if (he[i].fi == -1 || other == -1 || next == other) continue;
            for (int j = he[he[i].next].next; j != i; j = he[j].next)
                apart += he[he[j].opp].fi == other;
        }
    }
    CHECK(apart > 20);
}

TEST_CASE("parts of a random mesh stand side by side") {
    RandomMesh options;
    options.parts = 6;
    options.surface = Surface::closed;
    const IndexedMesh mesh = random_polygons(3, options);
    std::vector<std::pair<double, double>> extents;
    for (const auto& component : components_of(mesh)) {
        double low = 1e9;
        double high = -1e9;
        for (const int v : component) {
            low = std::min(low, mesh.positions[at(v)].x);
            high = std::max(high, mesh.positions[at(v)].x);
        }
        extents.emplace_back(low, high);
    }
    std::sort(extents.begin(), extents.end());
    REQUIRE(extents.size() == 6);
    for (std::size_t k = 1; k < extents.size(); ++k)
        CHECK(extents[k - 1].second < extents[k].first);
}

TEST_CASE("a seed gives the same faces on every platform, another one others") {
    RandomMesh options;
    options.faces = 1000;
    options.parts = 4;
    options.surface = Surface::mixed;
    CHECK(random_polygons(7, options) == random_polygons(7, options));
    CHECK(fingerprint(random_polygons(7, options)) !=
          fingerprint(random_polygons(8, options)));
    CHECK(fingerprint(random_polygons(7, options)) == 16402745432137473498U);
    CHECK(fingerprint(icosphere(3)) == 7174126586782743442U);
}

TEST_CASE("a random mesh can be large") {
    RandomMesh options;
    options.faces = 200'000;
    options.surface = Surface::mixed;
    options.parts = 3;
    const IndexedMesh mesh = random_polygons(1, options);
    CHECK(mesh.faces.size() > 50'000);
    CHECK(mesh.faces.size() < 200'000);
    CHECK(validate(build(mesh)).empty());
}

TEST_CASE("random meshes refuse options that make no sense") {
    const auto refuses = [](auto member, int value) {
        RandomMesh options;
        options.*member = value;
        CHECK_THROWS_AS(random_polygons(1, options), std::invalid_argument);
    };
    refuses(&RandomMesh::faces, 0);
    refuses(&RandomMesh::parts, 0);
    refuses(&RandomMesh::parts, 101);
    refuses(&RandomMesh::max_sides, 3);
    refuses(&RandomMesh::merge_percent, 101);
    refuses(&RandomMesh::merge_percent, -1);
    refuses(&RandomMesh::hole_percent, 101);
    refuses(&RandomMesh::hole_percent, -1);
}
