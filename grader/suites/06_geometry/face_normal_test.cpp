// Hidden suite of face_normal. Triangles near the limit between thin and
// degenerate keep away from it by a third, and are exact in double.
#include "exercises/06_geometry/face_normal.h"

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

void check_normal(const Corners& t, Vec3 expected) {
    const std::optional<Vec3> got = face_normal(t[0], t[1], t[2]);
    REQUIRE(got.has_value());
    CHECK_THAT(*got, IsDirection(expected));
}

void check_none(const Corners& t) {
    CHECK(face_normal(t[0], t[1], t[2]) == std::nullopt);
}

/// From each corner, and the other way round with the other front.
void check_all_orders(Corners t, Vec3 expected) {
    for (int turn = 0; turn < 3; ++turn) {
        check_normal(t, expected);
        check_normal({t[0], t[2], t[1]}, -1.0 * expected);
        std::rotate(t.begin(), t.begin() + 1, t.end());
    }
}

void check_none_in_any_order(Corners t) {
    for (int turn = 0; turn < 3; ++turn) {
        check_none(t);
        check_none({t[0], t[2], t[1]});
        std::rotate(t.begin(), t.begin() + 1, t.end());
    }
}

Corners scaled(double s, const Corners& t) {
    return {s * t[0], s * t[1], s * t[2]};
}

Corners in_motion(const Corners& t, const normals::Motion& motion) {
    return {motion.point(t[0]), motion.point(t[1]), motion.point(t[2])};
}

/// Twice the area is `ratio` times the square of the longest side, up to the
/// square of the ratio: a needle with a short side, and one without.
std::vector<Corners> needles(double ratio) {
    return {{{{0, 0, 0}, {ratio, 0, 0}, {0, 1, 0}}},
            {{{0, 0, 0}, {1, 0, 0}, {0.5, ratio, 0}}},
            {{{0, 0, 0}, {1, 0, 0}, {0.25, ratio, 0}}}};
}

std::vector<Corners> random_triangles(int count, std::uint64_t salt) {
    const std::vector<Vec3> points = normals::random_points(3 * count, salt);
    std::vector<Corners> triangles;
    for (std::size_t k = 0; k + 2 < points.size(); k += 3)
        if (const Corners t{points[k], points[k + 1], points[k + 2]};
            length(normals::twice_shadows(t)) > 1e-3)
            triangles.push_back(t);
    return triangles;
}

}  // namespace

TEST_CASE("triangles in all directions", "[points:1]") {
    hint("To which side does the normal point, and how long is it?");
    check_all_orders({{{0, 0, 0}, {2, 0, 0}, {0, 5, 0}}}, {0, 0, 1});
    check_all_orders({{{0, 0, 0}, {0, 2, 0}, {0, 0, 5}}}, {1, 0, 0});
    check_all_orders({{{0, 0, 0}, {0, 0, 2}, {5, 0, 0}}}, {0, 1, 0});
    check_all_orders({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 1});
    check_all_orders({{{2, -1, 3}, {5, 3, 3}, {2, -1, 8}}}, {4, -3, 0});
    check_all_orders({{{1, 1, 1}, {2, 3, 4}, {4, 2, 1}}}, {-3, 9, -5});
}

TEST_CASE("the faces of meshes", "[points:1]") {
    hint("On a closed mesh that is well oriented, where do the normals point?");
    for (const Fixture& fixture :
         {normals::box({1, 1, 1}), normals::box({1, 2, 3}), zoo::tetra(),
          zoo::torus7(), renumbered(zoo::torus7()), zoo::fan6()}) {
        const OnMesh on(fixture);
        for (int f = 0; f < fixture.mesh.faces.size(); ++f) {
            const auto t = normals::corners_of(fixture.mesh, f);
            check_normal({t[0], t[1], t[2]}, normals::twice_shadows(t));
        }
    }
}

TEST_CASE("random triangles, turned and of any size", "[points:1]") {
    hint("Does the normal of a larger triangle come out longer?");
    for (const Corners& t : random_triangles(60, 1))
        for (const normals::Motion& motion : normals::motions())
            check_normal(in_motion(t, motion),
                         motion.direction(normals::twice_shadows(t)));
    for (const Corners& t : random_triangles(60, 2))
        check_normal(in_motion(t, normals::far_away()),
                     normals::twice_shadows(t));
}

TEST_CASE("very small and very large", "[points:1]") {
    hint("Small compared with what? The unit of length must not matter.");
    for (const double s : {1e-30, 1e-12, 1e-7, 1e-4, 1e5, 1e8, 1e30}) {
        check_all_orders(scaled(s, {{{0, 0, 0}, {2, 0, 0}, {0, 5, 0}}}),
                         {0, 0, 1});
        check_all_orders(scaled(s, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}),
                         {1, 1, 1});
    }
}

TEST_CASE("corners that coincide", "[points:1]") {
    hint("Which two numbers are compared when all corners are at one place?");
    const Vec3 p{1, 2, 3}, q{4, -5, 0.5};
    check_none_in_any_order({p, p, q});
    check_none_in_any_order({p, p, p});
    check_none_in_any_order({Vec3{}, Vec3{}, Vec3{}});
    for (const normals::Motion& motion : normals::motions()) {
        check_none_in_any_order(in_motion({p, p, q}, motion));
        check_none(in_motion({p, p, p}, motion));
    }
}

TEST_CASE("corners on a line, up to rounding", "[points:1]") {
    hint(
        "Is twice the area exactly zero here? What does the contract compare "
        "it with?");
    for (const Vec3 from : normals::random_points(20, 3)) {
        const Vec3 along{0.3 + from.y, 0.7 * from.z - 0.1, 1.1};
        for (const double s : {1e-6, 1.0, 1e6}) {
            check_none_in_any_order(
                scaled(s, {from, from + 0.3 * along, from + 1.7 * along}));
        }
    }
}

TEST_CASE("needles just wide enough", "[points:1]") {
    hint(
        "Is it twice the area that you compare, and with the square of the "
        "longest side, not of another one?");
    for (const double s : {1e-6, 1e-3, 1.0, 1e4, 1e9})
        for (const double ratio : {1.5e-12, 3e-12, 1e-10, 1e-6})
            for (const Corners& t : needles(ratio))
                check_all_orders(scaled(s, t), {0, 0, 1});
}

TEST_CASE("needles just too thin", "[points:1]") {
    hint("Which side is the longest, whatever corner comes first?");
    for (const double s : {1e-6, 1e-3, 1.0, 1e4, 1e9})
        for (const double ratio : {0.7e-12, 0.3e-12, 1e-14, 1e-16})
            for (const Corners& t : needles(ratio))
                check_none_in_any_order(scaled(s, t));
}
