// Hidden suite of area_vector: triangles with corners and areas that were
// worked out by hand, and random ones compared with their three shadows.
#include "exercises/06_geometry/area_vector.h"

#include <algorithm>
#include <array>
#include <vector>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"

using namespace course;

namespace {

using Corners = std::array<Vec3, 3>;

Vec3 asked(const Corners& t) {
    return area_vector(t[0], t[1], t[2]);
}

/// What an area is measured by: the square of the longest side.
double size_of(const Corners& t) {
    const double longest = std::max(
        {length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
    return longest * longest;
}

Corners in_motion(const Corners& t, const normals::Motion& motion) {
    return {motion.point(t[0]), motion.point(t[1]), motion.point(t[2])};
}

std::vector<Corners> random_triangles(int count, std::uint64_t salt) {
    const std::vector<Vec3> points = normals::random_points(3 * count, salt);
    std::vector<Corners> triangles;
    for (std::size_t k = 0; k + 2 < points.size(); k += 3)
        triangles.push_back({points[k], points[k + 1], points[k + 2]});
    return triangles;
}

/// All corners from each in turn: the same triangle, the same vector.
void check_from_each_corner(Corners t, Vec3 expected) {
    for (int turn = 0; turn < 3; ++turn) {
        CHECK_THAT(asked(t), IsAt(expected, length(expected)));
        std::rotate(t.begin(), t.begin() + 1, t.end());
    }
}

}  // namespace

TEST_CASE("in the planes of the axes", "[points:1]") {
    hint(
        "For each plane: from which side do the corners run "
        "counter-clockwise?");
    check_from_each_corner({{{0, 0, 0}, {2, 0, 0}, {0, 5, 0}}}, {0, 0, 10});
    check_from_each_corner({{{0, 0, 0}, {0, 2, 0}, {0, 0, 5}}}, {10, 0, 0});
    check_from_each_corner({{{0, 0, 0}, {0, 0, 2}, {5, 0, 0}}}, {0, 10, 0});
    check_from_each_corner({{{0, 5, 0}, {2, 0, 0}, {0, 0, 0}}}, {0, 0, -10});
    check_from_each_corner({{{0, 0, 5}, {0, 2, 0}, {0, 0, 0}}}, {-10, 0, 0});
    check_from_each_corner({{{5, 0, 0}, {0, 0, 2}, {0, 0, 0}}}, {0, -10, 0});
}

TEST_CASE("anywhere in space", "[points:1]") {
    hint(
        "Do all three coordinates of the vector come out right, and is it "
        "twice the area?");
    check_from_each_corner({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 1});
    check_from_each_corner({{{2, -1, 3}, {5, 3, 3}, {2, -1, 8}}}, {20, -15, 0});
    check_from_each_corner({{{1, 1, 1}, {2, 3, 4}, {4, 2, 1}}}, {-3, 9, -5});
    check_from_each_corner({{{-7, 2, 5}, {-6, 4, 7}, {-9, 4, 6}}}, {-2, -5, 6});
}

TEST_CASE("the three shadows of random triangles", "[points:1]") {
    hint("Each coordinate is twice the area of a shadow. Which sign has it?");
    for (const Corners& t : random_triangles(200, 1))
        CHECK_THAT(asked(t), IsAt(normals::twice_shadows(t), size_of(t)));
}

TEST_CASE("two corners swapped turn it round", "[points:1]") {
    hint("What should happen to the front when two corners change places?");
    for (const Corners& t : random_triangles(50, 2)) {
        const Vec3 back = -1.0 * normals::twice_shadows(t);
        CHECK_THAT(area_vector(t[0], t[2], t[1]), IsAt(back, size_of(t)));
        CHECK_THAT(area_vector(t[1], t[0], t[2]), IsAt(back, size_of(t)));
        CHECK_THAT(area_vector(t[2], t[1], t[0]), IsAt(back, size_of(t)));
    }
}

TEST_CASE("turned, and of another size", "[points:1]") {
    hint("A triangle twice as large has four times the area. And yours?");
    for (const normals::Motion& motion : normals::motions())
        for (const Corners& t : random_triangles(40, 3)) {
            const double s = motion.scale;
            CHECK_THAT(asked(in_motion(t, motion)),
                       IsAt(s * s * motion.direction(normals::twice_shadows(t)),
                            s * s * size_of(t)));
        }
}

TEST_CASE("no area at all", "[points:1]") {
    hint("What is the product of two edge vectors that lie on one line?");
    const std::vector<Corners> degenerate = {
        {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}},
        {{{1, 2, 3}, {1, 2, 3}, {4, 0, 1}}},
        {{{4, 0, 1}, {1, 2, 3}, {1, 2, 3}}},
        {{{1, 2, 3}, {4, 0, 1}, {1, 2, 3}}},
        {{{0, 0, 0}, {2, 4, 6}, {1, 2, 3}}},
        {{{-1, 5, 2}, {1, 2, 3}, {5, -4, 5}}},
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    for (const normals::Motion& motion : normals::motions())
        for (const Corners& t : degenerate) {
            const double s = motion.scale;
            CHECK_THAT(asked(in_motion(t, motion)), IsAt({}, 100 * s * s));
        }
}

TEST_CASE("far from the origin", "[points:1]") {
    hint(
        "Which numbers grow with the distance from the origin, and which "
        "digits of them are lost?");
    for (const Corners& t : random_triangles(100, 4))
        CHECK_THAT(asked(in_motion(t, normals::far_away())),
                   IsAt(normals::twice_shadows(t), size_of(t)));
}
