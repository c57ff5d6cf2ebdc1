#include "exercises/09_processing/hausdorff.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

Fixture one(std::string name, Vec3 a, Vec3 b, Vec3 c) {
    return {std::move(name), {{a, b, c}, {{0, 1, 2}}, {}}, {}};
}

const Vec3 o{0, 0, 0}, x{2, 0, 0}, y{0, 2, 0};

}  // namespace

TEST_CASE("a triangle and the same one elsewhere", "[points:1]") {
    hint(
        "How far is the nearest point of the other triangle, for each corner?");
    const Fixture a = one("triangle", o, x, y);
    const OnMesh on(a);
    const Vec3 up{0, 0, 3}, aside{4, 0, 0};
    CHECK_THAT(hausdorff(a.mesh, a.mesh), IsAbout(0, 2));
    CHECK_THAT(hausdorff(a.mesh, one("above", o + up, x + up, y + up).mesh),
               IsAbout(3));
    CHECK_THAT(
        hausdorff(a.mesh, one("aside", o + aside, x + aside, y + aside).mesh),
        IsAbout(4));
}

TEST_CASE("a triangle in the corner of another one", "[points:1]") {
    hint("Whose vertices do you ask about: only those of a, or of b as well?");
    const Fixture a = one("triangle", o, x, y);
    const Fixture b = one("small triangle", o, 0.5 * x, 0.5 * y);
    const OnMesh on(a);
    CHECK_THAT(hausdorff(a.mesh, b.mesh), IsAbout(1));
    CHECK_THAT(hausdorff(b.mesh, a.mesh), IsAbout(1));
}

TEST_CASE("a triangle without an area is a segment", "[points:1]") {
    hint("What is the normal of a triangle whose corners lie on one line?");
    const Fixture a = one("triangle", o, x, y);
    const Fixture b = one("segment", o, x, 0.5 * x);
    const OnMesh on(a);
    CHECK_THAT(hausdorff(a.mesh, b.mesh), IsAbout(2));
}

TEST_CASE("a mesh without a face has no surface", "[points:1]") {
    hint("What is the nearest point of nothing?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    CHECK_THROWS_AS(hausdorff(tetra.mesh, {}), std::invalid_argument);
    CHECK_THROWS_AS(hausdorff({}, tetra.mesh), std::invalid_argument);
}
