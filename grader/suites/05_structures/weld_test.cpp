// Hidden suite of weld. What is expected comes from meshes whose vertices lie
// apart, torn into soups, and from points in a row, worked out by hand.
#include "exercises/05_structures/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "course/runner/suite.h"
#include "grader/suites/05_structures/structures_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

/// The smallest distance between two vertices.
double spacing(const IndexedMesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < mesh.positions.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            least =
                std::min(least, length(mesh.positions[a] - mesh.positions[b]));
    return least;
}

/// Triangle meshes whose vertices all lie apart; two without a table, too.
std::vector<Fixture> meshes_to_tear() {
    std::vector<Fixture> meshes = hidden::triangle_meshes();
    for (const Fixture& more : hidden::generated_triangle_meshes())
        meshes.push_back(more);
    meshes.push_back(zoo::fan3());
    meshes.push_back(zoo::moebius5());
    std::erase_if(meshes,
                  [](const Fixture& f) { return spacing(f.mesh) < 1e-3; });
    return meshes;
}

/// The same faces, the vertices numbered as the faces first name them, at the
/// points where the soup has that corner.
IndexedMesh in_order_of_use(const IndexedMesh& mesh, const Soup& soup) {
    std::map<int, int> number;
    IndexedMesh result;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<int> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const int next = static_cast<int>(number.size());
            const auto [at, fresh] = number.emplace(mesh.faces[f][k], next);
            if (fresh)
                result.positions.push_back(
                    soup[static_cast<std::size_t>(f)][k]);
            corners.push_back(at->second);
        }
        result.faces.push_back(corners);
    }
    return result;
}

/// A soup of points: the corners of its triangles, one after the other. The
/// last triangle is filled up with a point far away.
Soup from_points(std::vector<Vec3> points) {
    while (points.size() % 3 != 0) points.push_back({1e6, 1e6, 1e6});
    Soup soup;
    for (std::size_t k = 0; k < points.size(); k += 3)
        soup.push_back({points[k], points[k + 1], points[k + 2]});
    return soup;
}

/// The vertices that weld gives to these points.
std::vector<int> vertices_of(const std::vector<Vec3>& points, double eps) {
    std::vector<int> corners = weld(from_points(points), eps).faces.corners();
    if (corners.size() > points.size()) corners.resize(points.size());
    return corners;
}

/// Whether a corner at `offset` from a vertex is joined with it.
bool joined(Vec3 offset, double eps, Vec3 at = {1, 2, -3}) {
    return vertices_of({at, at + offset}, eps) == std::vector<int>{0, 0};
}

}  // namespace

TEST_CASE("meshes that were torn into triangles", "[points:2]") {
    hint("In which order do new vertices get their numbers?");
    for (const Fixture& fixture : meshes_to_tear()) {
        const OnMesh on(fixture);
        const Soup soup = hidden::torn(fixture.mesh);
        const IndexedMesh expected = in_order_of_use(fixture.mesh, soup);
        for (const double eps : {0.0, 1e-9, spacing(fixture.mesh) / 2}) {
            const IndexedMesh got = weld(soup, eps);
            REQUIRE(got.faces == expected.faces);
            REQUIRE(got.positions == expected.positions);
            REQUIRE(got.loose_edges.empty());
        }
    }
}

TEST_CASE("corners that are not quite at the same point", "[points:1]") {
    hint("Where does a vertex lie whose corners lie at several points?");
    std::mt19937_64 random(seed());
    const auto noise = [&] {
        return static_cast<double>(random() % 2001) / 1000 - 1;
    };
    for (const Fixture& fixture : meshes_to_tear()) {
        const OnMesh on(fixture);
        for (const double scale : {1e-3, 1.0, 1e4}) {
            const double eps = scale * spacing(fixture.mesh) / 4;
            Soup soup = hidden::torn(fixture.mesh);
            for (SoupTriangle& triangle : soup)
                for (Vec3& corner : triangle)
                    corner = scale * (corner + Vec3{50, -70, 20}) +
                             0.25 * eps * Vec3{noise(), noise(), noise()};
            const IndexedMesh expected = in_order_of_use(fixture.mesh, soup);
            const IndexedMesh got = weld(soup, eps);
            REQUIRE(got.faces == expected.faces);
            REQUIRE(got.positions == expected.positions);
        }
    }
}

TEST_CASE("a distance of just eps, and one of a little more", "[points:1]") {
    hint("Is a corner at the distance eps still joined, in every direction?");
    // Numbers without rounding: 3-4-5 and 2-3-6-7 are right triangles and
    // boxes with whole sides and diagonals.
    for (const double unit : {0x1p-12, 0x1p-3, 1.0, 0x1p9}) {
        for (const double sign : {1.0, -1.0}) {
            const double s = sign * unit;
            for (const Vec3 axis :
                 {Vec3{5 * s, 0, 0}, Vec3{0, 5 * s, 0}, Vec3{0, 0, 5 * s},
                  Vec3{3 * s, 4 * s, 0}, Vec3{0, 3 * s, -4 * s}})
                CHECK(joined(axis, 5 * unit, {}));
            CHECK(joined({2 * s, 3 * s, 6 * s}, 7 * unit, {}));
            CHECK_FALSE(joined({5.001 * s, 0, 0}, 5 * unit));
            CHECK_FALSE(joined({0, 5.001 * s, 0}, 5 * unit));
            CHECK_FALSE(joined({0, 0, 5.001 * s}, 5 * unit));
            CHECK_FALSE(joined({3 * s, 4.1 * s, 0}, 5 * unit));
            CHECK_FALSE(joined({4.9 * s, 4.9 * s, 0}, 5 * unit));
            CHECK_FALSE(joined({3 * s, -3 * s, 3 * s}, 5 * unit));
            CHECK(joined({2.8 * s, -2.8 * s, 2.8 * s}, 5 * unit));
        }
    }
}

TEST_CASE("points close together on either side of a round number",
          "[points:1]") {
    hint("Does it matter where in space the two points lie?");
    for (const double eps : {0.01, 0.5, 1.0, 3.0})
        for (int k = -12; k <= 12; ++k) {
            const double at = k * eps / 4;
            const Vec3 near{0.4 * eps, 0.4 * eps, -0.4 * eps};
            const Vec3 beside{1.01 * eps, 0, 0};
            CHECK(joined(near, eps, {at, -at, at + 7}));
            CHECK_FALSE(joined(beside, eps, {at, -at, at + 7}));
        }
}

TEST_CASE("several vertices within reach, and chains of points", "[points:1]") {
    hint("Which vertex is it when two are near enough, and who is compared?");
    // Vertices at 0 and 1.5; the third point is nearer to the second.
    CHECK(vertices_of({{0}, {1.5}, {0.9}}, 1) == std::vector<int>{0, 1, 0});
    CHECK(vertices_of({{1.5}, {0}, {0.6}}, 1) == std::vector<int>{0, 1, 0});
    CHECK(vertices_of({{0}, {0.5, 0.9}, {0.5, 0.4}, {0.5, 1.2}}, 1) ==
          std::vector<int>{0, 1, 0, 1});
    // Each is near the one before, not the vertex that this one became.
    CHECK(vertices_of({{0}, {0.75}, {1.5}, {2.25}, {3}, {3.75}}, 1) ==
          std::vector<int>{0, 0, 1, 1, 2, 2});
    CHECK(vertices_of({{0}, {-0.75}, {-1.5}, {-0.75}}, 1) ==
          std::vector<int>{0, 0, 1, 0});
    // A vertex that moved to the mean of its corners would reach the last.
    CHECK(vertices_of({{0}, {0.9}, {0.9}, {0.9}, {1.5}}, 1) ==
          std::vector<int>{0, 0, 0, 0, 1});
    CHECK(vertices_of({{0}, {-0.9}, {-0.9}, {0.9}}, 1) ==
          std::vector<int>{0, 0, 0, 0});
}

TEST_CASE("zeros of both signs, and points that differ in one digit",
          "[points:1]") {
    hint("When are two coordinates equal?");
    CHECK(vertices_of({{0, 0, 0}, {-0.0, 0, 0}, {0, -0.0, -0.0}}, 0) ==
          std::vector<int>{0, 0, 0});
    CHECK(vertices_of({{-0.0, 5, -0.0}, {0.0, 5, -0.0}, {0, -5, 0}}, 0) ==
          std::vector<int>{0, 0, 1});
    const double one = std::nextafter(1.0, 2.0);
    CHECK(vertices_of({{1, 1, 1}, {one, 1, 1}, {1, 1, one}}, 0) ==
          std::vector<int>{0, 1, 2});
    CHECK(vertices_of({{1, 2, 3}, {3, 2, 1}, {2, 1, 3}, {1, 2, 3}}, 0) ==
          std::vector<int>{0, 1, 2, 0});
}

TEST_CASE("triangles that shrink to an edge or a point stay", "[points:1]") {
    hint("Is face k triangle k, whatever became of its corners?");
    const Soup soup = {{{{0, 0, 0}, {1, 0, 0}, {0.01, 0, 0}}},
                       {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}},
                       {{{0, 1, 0}, {0, 1.01, 0}, {0, 1, 0.01}}},
                       {{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}}},
                       {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}};
    const IndexedMesh got = weld(soup, 0.1);
    CHECK(got.faces ==
          FaceList{{0, 1, 0}, {1, 2, 0}, {2, 2, 2}, {2, 0, 1}, {1, 2, 0}});
    CHECK(got.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const IndexedMesh all_one = weld(hidden::torn(zoo::torus7().mesh), 1e3);
    CHECK(all_one.positions.size() == 1);
    CHECK(all_one.faces.corners() == std::vector<int>(42, 0));
    CHECK(weld(Soup(), 0) == IndexedMesh());
}

TEST_CASE("an eps that is no distance is refused", "[points:1]") {
    hint("Which comparisons hold for NaN?");
    const Soup soup = hidden::torn(zoo::tetra().mesh);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double eps : {-1.0, -1e-300, nan, -nan})
        for (const Soup& any : {soup, Soup()})
            CHECK_THROWS_AS(weld(any, eps), std::invalid_argument);
    CHECK(weld(soup, 0).positions.size() == 4);
    CHECK(weld(soup, -0.0).positions.size() == 4);
}
