// Hidden suite of transform_normal. The oracle does not invert a matrix: it
// transforms two tangents and takes the normal of what they span, or takes maps
// apart into those whose effect on a normal is known.
#include "exercises/06_geometry/transform_normal.h"

#include <array>
#include <vector>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"

using namespace course;

namespace {

constexpr Mat3 identity{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

Mat3 diagonal(double x, double y, double z) {
    return {{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}};
}

Mat3 scaled(double s, Mat3 m) {
    for (Vec3& row : m.rows) row = s * row;
    return m;
}

double determinant(const Mat3& m) {
    const auto& [a, b, c] = m.rows;
    return dot(a, cross(b, c));
}

/// Two vectors that are orthogonal to n, and so that (p, q, n) is right-handed.
std::array<Vec3, 2> tangents(Vec3 n) {
    const Vec3 other =
        std::abs(n.x) < std::abs(n.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 p = cross(other, n);
    return {p, cross(n, p)};
}

/// The normal of the transformed tangents, on the side on which n was.
Vec3 expected_of(const Mat3& m, Vec3 n) {
    const auto [p, q] = tangents(n);
    const Vec3 upright = cross(m * p, m * q);
    return dot(upright, m * n) < 0 ? -1.0 * upright : upright;
}

void check_transformed(const Mat3& m, Vec3 n) {
    CHECK_THAT(transform_normal(m, n), IsDirection(expected_of(m, n)));
}

std::vector<Vec3> random_normals(int count, std::uint64_t salt) {
    std::vector<Vec3> normals = normals::random_points(count, salt);
    std::erase_if(normals, [](Vec3 n) { return length(n) < 0.1; });
    return normals;
}

/// Far from singular; about half of them mirror.
std::vector<Mat3> random_matrices(int count, std::uint64_t salt) {
    const std::vector<Vec3> rows = normals::random_points(3 * count, salt);
    std::vector<Mat3> matrices;
    for (std::size_t k = 0; k + 2 < rows.size(); k += 3)
        if (const Mat3 m{{rows[k], rows[k + 1], rows[k + 2]}};
            std::abs(determinant(m)) > 0.05)
            matrices.push_back(m);
    return matrices;
}

void check_singular(const Mat3& m) {
    for (const Vec3 n : {Vec3{0, 0, 1}, Vec3{1, 2, -3}})
        CHECK_THROWS_AS(transform_normal(m, n), std::domain_error);
}

}  // namespace

TEST_CASE("turns", "[points:1]") {
    hint("What is the inverse of a turn, and what its transpose?");
    for (const Vec3 n : random_normals(20, 1)) {
        CHECK_THAT(transform_normal(identity, n), IsDirection(n));
        for (const normals::Motion& motion : normals::motions())
            CHECK_THAT(transform_normal(motion.turn, n),
                       IsDirection(motion.direction(n)));
    }
    const Mat3 quarter{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}};
    CHECK_THAT(transform_normal(quarter, {1, 0, 0}), IsDirection({0, 1, 0}));
    const Mat3 round{{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}};
    CHECK_THAT(transform_normal(round, {1, 2, 3}), IsDirection({3, 1, 2}));
}

TEST_CASE("stretched by another factor along each axis", "[points:1]") {
    hint("Where the surface gets flatter, does the normal get steeper?");
    for (const Vec3 n : random_normals(30, 2)) {
        CHECK_THAT(transform_normal(diagonal(2, 1, 1), n),
                   IsDirection({n.x / 2, n.y, n.z}));
        CHECK_THAT(transform_normal(diagonal(1, 4, 0.5), n),
                   IsDirection({n.x, n.y / 4, 2 * n.z}));
        CHECK_THAT(transform_normal(diagonal(100, 1, 0.01), n),
                   IsDirection({n.x / 100, n.y, 100 * n.z}));
    }
}

TEST_CASE("shears", "[points:1]") {
    hint(
        "The inverse of a shear goes back. And transposed, which entry is "
        "that?");
    for (const Vec3 n : random_normals(30, 3)) {
        CHECK_THAT(transform_normal({{{{1, 3, 0}, {0, 1, 0}, {0, 0, 1}}}}, n),
                   IsDirection({n.x, n.y - 3 * n.x, n.z}));
        CHECK_THAT(transform_normal({{{{1, 0, 0}, {0, 1, 0}, {0, 2, 1}}}}, n),
                   IsDirection({n.x, n.y - 2 * n.z, n.z}));
        CHECK_THAT(transform_normal({{{{1, 0, 0}, {0, 1, 0}, {-2, 0, 1}}}}, n),
                   IsDirection({n.x + 2 * n.z, n.y, n.z}));
    }
}

TEST_CASE("mirrors keep the normal on its side", "[points:1]") {
    hint("Does the sign of the determinant have a part in your result?");
    for (const Vec3 n : random_normals(30, 4)) {
        CHECK_THAT(transform_normal(diagonal(-1, 1, 1), n),
                   IsDirection({-n.x, n.y, n.z}));
        CHECK_THAT(transform_normal(diagonal(1, 1, -3), n),
                   IsDirection({n.x, n.y, -n.z / 3}));
        CHECK_THAT(transform_normal(diagonal(-1, -1, -1), n),
                   IsDirection(-1.0 * n));
        const Mat3 swap{{{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}};
        CHECK_THAT(transform_normal(swap, n), IsDirection({n.y, n.x, n.z}));
    }
}

TEST_CASE("maps of every kind", "[points:1]") {
    hint(
        "Take two tangents of the surface: are they still orthogonal to the "
        "normal when all is transformed?");
    for (const Mat3& m : random_matrices(60, 5))
        for (const Vec3 n : random_normals(4, 6)) check_transformed(m, n);
}

TEST_CASE("one map after the other", "[points:1]") {
    hint(
        "Transform the result with a second matrix: is it as with the "
        "product of both?");
    const std::vector<Mat3> matrices = random_matrices(40, 7);
    for (std::size_t k = 0; k + 1 < matrices.size(); k += 2) {
        const Mat3 &m = matrices[k], &then = matrices[k + 1];
        const auto column = [&](double x, double y, double z) {
            return then * (m * Vec3{x, y, z});
        };
        const Vec3 x = column(1, 0, 0), y = column(0, 1, 0),
                   z = column(0, 0, 1);
        const Mat3 both{{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}}};
        for (const Vec3 n : random_normals(3, k))
            CHECK_THAT(transform_normal(then, transform_normal(m, n)),
                       IsDirection(expected_of(both, n)));
    }
}

TEST_CASE("normals of any length, matrices of any size", "[points:1]") {
    hint("A matrix of tiny numbers has a tiny determinant. Is it singular?");
    const Mat3 m{{{{1, 2, 0}, {0, 1, -1}, {3, 0, 1}}}};
    for (const double s : {1e-30, 1e-10, 1e-5, 1e-3, 1e4, 1e10, 1e30}) {
        for (const Vec3 n : random_normals(5, 8)) {
            CHECK_THAT(transform_normal(scaled(s, m), n),
                       IsDirection(expected_of(m, n)));
            CHECK_THAT(transform_normal(scaled(-s, m), n),
                       IsDirection(-1.0 * expected_of(m, n)));
            CHECK_THAT(transform_normal(m, s * n),
                       IsDirection(expected_of(m, n)));
        }
    }
}

TEST_CASE("almost flat, but not singular", "[points:1]") {
    hint(
        "How flat may it be? With what does the contract compare the "
        "determinant?");
    for (const double flat : {1e-5, 1e-9, 1e-11}) {
        const Mat3 squeezed{{{{1, 0, 0}, {1, flat, 0}, {0, 0, 1}}}};
        CHECK_THAT(transform_normal(squeezed, {0, 1, 0}),
                   IsDirection({-1, 1, 0}));
        CHECK_THAT(transform_normal(squeezed, {0, 0, 1}),
                   IsDirection({0, 0, 1}));
    }
    // Flat along an axis, which makes one row short: the determinant is no
    // smaller than the product of the rows.
    for (const double flat : {1e-9, 1e-15, 1e-20}) {
        CHECK_THAT(transform_normal(diagonal(1, 1, flat), {0, 0, 1}),
                   IsDirection({0, 0, 1}));
        CHECK_THAT(transform_normal(diagonal(flat, 1, flat), {0, 1, 0}),
                   IsDirection({0, 1, 0}));
        CHECK_THAT(transform_normal(diagonal(1, -flat, 1), {0, 1, 0}),
                   IsDirection({0, -1, 0}));
    }
}

TEST_CASE("singular matrices are refused", "[points:1]") {
    hint("Is the determinant exactly zero here? What is the contract's limit?");
    check_singular(diagonal(0, 0, 0));
    check_singular(diagonal(1, 1, 0));
    check_singular(diagonal(0, 1, 1));
    check_singular({{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}});
    check_singular({{{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}}}});
    check_singular({{{{1, 0, 2}, {0, 0, 1}, {3, 0, 1}}}});
    for (const double s : {1e-6, 1e-3, 1.0, 1e4, 1e9}) {
        check_singular(
            scaled(s, {{{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}}}}));
        check_singular(scaled(s, {{{{1, 0, 0}, {1, 1e-13, 0}, {0, 0, 1}}}}));
        check_singular(scaled(s, {{{{1, 0, 0}, {1, -1e-14, 0}, {0, 0, 1}}}}));
        const std::vector<Vec3> rows = normals::random_points(30, 9);
        for (std::size_t k = 0; k + 1 < rows.size(); k += 2)
            check_singular(scaled(
                s,
                {{rows[k], 0.3 * rows[k] + 0.7 * rows[k + 1], rows[k + 1]}}));
    }
}
