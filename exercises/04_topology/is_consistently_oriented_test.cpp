#include "exercises/04_topology/is_consistently_oriented.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

void check_oriented(const Fixture& fixture, bool expected) {
    const OnMesh on(fixture);
    CHECK(is_consistently_oriented(fixture.mesh) == expected);
}

}  // namespace

TEST_CASE("the slide mesh, and the same with its quad turned over",
          "[points:1]") {
    hint("Along which shared edge do two faces run in the same direction?");
    check_oriented(zoo::slide(), true);
    Fixture turned = zoo::slide();
    turned.mesh.faces = {{0, 2, 1}, {4, 5, 2, 1}, {2, 3, 5}};
    turned.he = {};
    check_oriented(turned, false);
}

TEST_CASE("meshes of the zoo", "[points:1]") {
    hint("Which sides does a face have, and which one closes it?");
    check_oriented(zoo::tetra(), true);
    check_oriented(zoo::moebius3q(), false);
    check_oriented(zoo::annulus(), true);
    check_oriented(zoo::moebius5(), false);
    check_oriented(zoo::torus7(), true);
    check_oriented(zoo::klein4x4(), false);
    check_oriented(zoo::two_triangles(), true);
    check_oriented(zoo::fan3(), false);
}
