// Hidden suite of planarity_error: quads by the distance of their diagonals,
// and polygons by their shadows.
#include "exercises/06_geometry/planarity_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"

using namespace course;

namespace {

using Polygon = std::vector<Vec3>;

double size_of(const Polygon& corners) {
    return std::sqrt(normals::squared_sides(corners));
}

void check_error(const Polygon& corners, double expected) {
    const std::optional<double> got = planarity_error(corners);
    REQUIRE(got.has_value());
    CHECK_THAT(*got, IsAbout(expected, size_of(corners)));
}

/// From each corner, and in the other sense.
void check_all_orders(Polygon corners, double expected) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        check_error(corners, expected);
        check_error(Polygon(corners.rbegin(), corners.rend()), expected);
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
}

void check_in_all_motions(const Polygon& corners, double expected) {
    for (const normals::Motion& motion : normals::motions())
        check_error(normals::moved(corners, motion), motion.scale * expected);
}

void check_none(Polygon corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        CHECK(planarity_error(corners) == std::nullopt);
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
}

void check_none_in_all_motions(const Polygon& corners) {
    for (const normals::Motion& motion : normals::motions())
        check_none(normals::moved(corners, motion));
}

/// Half the distance of the lines through the diagonals.
double of_diagonals(const Polygon& quad) {
    const Vec3 n = cross(quad[2] - quad[0], quad[3] - quad[1]);
    return std::abs(dot(n, quad[1] - quad[0])) / length(n) / 2;
}

double of_polygon(const Polygon& corners) {
    const Vec3 n = normals::twice_shadows(corners);
    std::vector<double> heights;
    double mean = 0;
    for (const Vec3 p : corners) {
        heights.push_back(dot(n, p - corners[0]) / length(n));
        mean += heights.back() / static_cast<double>(corners.size());
    }
    const auto [low, high] =
        std::minmax_element(heights.begin(), heights.end());
    return std::max(*high - mean, mean - *low);
}

/// Polygons of n corners that are far from having no normal.
std::vector<Polygon> random_polygons_of(int n, int count, std::uint64_t salt) {
    std::vector<Polygon> all;
    for (int k = 0; k < count; ++k) {
        const Polygon corners = normals::random_points(
            n, salt * 1000 + static_cast<std::uint64_t>(k));
        if (length(normals::twice_shadows(corners)) >
            0.01 * normals::squared_sides(corners))
            all.push_back(corners);
    }
    return all;
}

/// A regular polygon; its corners are lifted by `up` and let down by it in
/// turn.
Polygon zigzag(int n, double up) {
    Polygon corners;
    for (int k = 0; k < n; ++k)
        corners.push_back({std::cos(6.283185307179586 * k / n),
                           std::sin(6.283185307179586 * k / n),
                           k % 2 == 0 ? up : -up});
    return corners;
}

}  // namespace

TEST_CASE("triangles and flat polygons", "[points:1]") {
    hint("Is the result 0 when all corners lie in a plane?");
    for (int n = 3; n <= 12; ++n) check_in_all_motions(zigzag(n, 0), 0);
    check_in_all_motions({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0);
    check_in_all_motions({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}, 0);
    for (const Polygon& corners : random_polygons_of(3, 20, 1))
        check_all_orders(corners, 0);
}

TEST_CASE("quads: half the distance of the diagonals", "[points:1]") {
    hint("Two corners lie above the mean plane and two below. How far?");
    check_all_orders({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, 0.5);
    check_all_orders({{3, 0, 0}, {0, 3, 2}, {-1, 0, 0}, {0, -1, 2}}, 1);
    for (const Polygon& quad : random_polygons_of(4, 40, 2))
        check_all_orders(quad, of_diagonals(quad));
}

TEST_CASE("polygons with corners up and down", "[points:1]") {
    hint("Do you take the greatest of all distances, above and below?");
    for (int n = 4; n <= 12; n += 2)
        for (const double up : {0.001, 0.25, 1.0})
            check_in_all_motions(zigzag(n, up), up);
    // Above the mean plane z = 0.75 some are far, below it others are farther.
    check_all_orders({{2, 0, 7},
                      {2, 2, 1},
                      {0, 2, -6},
                      {-2, 2, 1},
                      {-2, 0, 7},
                      {-2, -2, 1},
                      {0, -2, -6},
                      {2, -2, 1}},
                     6.75);
}

TEST_CASE("bent polygons", "[points:1]") {
    hint(
        "Which normal has the mean plane, and through which point does it "
        "go?");
    for (int n = 5; n <= 10; ++n)
        for (const Polygon& corners :
             random_polygons_of(n, 6, static_cast<std::uint64_t>(n)))
            check_all_orders(corners, of_polygon(corners));
}

TEST_CASE("turned, moved, small and large", "[points:1]") {
    hint("A polygon twice as large has twice the error. And yours?");
    for (const int n : {4, 6, 7})
        for (const Polygon& corners : random_polygons_of(n, 15, 20))
            check_in_all_motions(corners, of_polygon(corners));
    for (const double s : {1e-20, 1e-9, 1e-6, 1e9}) {
        Polygon quad = {{0, 0, 0}, {s, 0, s}, {s, s, 0}, {0, s, s}};
        check_all_orders(quad, 0.5 * s);
    }
}

TEST_CASE("far from the origin", "[points:1]") {
    hint("Which sums in your program get huge there?");
    for (const int n : {3, 4, 5, 8})
        for (const Polygon& corners : random_polygons_of(n, 20, 30))
            check_error(normals::moved(corners, normals::far_away()),
                        of_polygon(corners));
}

TEST_CASE("polygons without a normal", "[points:1]") {
    hint("When does the area vector say nothing? With what is it compared?");
    const Vec3 along{0.3, 0.7, 1.1};
    check_none_in_all_motions({Vec3{}, 0.3 * along, 1.7 * along});
    check_none_in_all_motions(
        {0.1 * along, 0.7 * along, 1.3 * along, 0.9 * along});
    check_none_in_all_motions({along, along, along});
    check_none_in_all_motions({along, along, along, along, along});
    check_none({Vec3{}, Vec3{}, Vec3{}});
    // It crosses itself: one half is seen from the front, one from the back.
    check_none_in_all_motions({{0.1, 0.2}, {1.3, 1.4}, {1.3, 0.2}, {0.1, 1.4}});
}

TEST_CASE("thin polygons, near the limit", "[points:1]") {
    hint("Are all sides in the sum, and is the area vector twice the area?");
    // Twice the area is 2 w, the squares of the sides are 6 in all.
    for (const double s : {1e-6, 1.0, 1e4}) {
        const auto thin = [&](double w) {
            return Polygon{{0, 0, 0}, {s, w * s, 0}, {2 * s, 0, 0}};
        };
        for (const double w : {4.5e-12, 1e-10, 1e-6})
            check_all_orders(thin(w), 0);
        for (const double w : {2e-12, 0.5e-12, 1e-14}) check_none(thin(w));
    }
}

TEST_CASE("fewer than three corners", "[points:1]") {
    hint("What is asked first, before any corner is looked at?");
    for (const Polygon& corners :
         {Polygon{}, Polygon{{1, 2, 3}}, Polygon{{1, 2, 3}, {4, 5, 6}},
          Polygon{{0, 0, 0}, {0, 0, 0}}})
        CHECK_THROWS_AS(planarity_error(corners), std::invalid_argument);
}
