#include "exercises/04_topology/is_closed.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

void check_closed(const Fixture& fixture, bool expected) {
    const OnMesh on(fixture);
    CHECK(is_closed(fixture.he) == expected);
}

}  // namespace

TEST_CASE("the slide mesh is open, a tetrahedron is closed", "[points:1]") {
    hint("How do you see in the table that an edge lacks a face?");
    check_closed(zoo::slide(), false);
    check_closed(zoo::tetra(), true);
}

TEST_CASE("closed and open meshes of the zoo", "[points:1]") {
    hint("How much of the table must be seen before the answer is certain?");
    check_closed(zoo::cube(), true);
    check_closed(zoo::annulus(), false);
    check_closed(zoo::torus7(), true);
    check_closed(zoo::pillow(), true);
    check_closed(zoo::fan6(), false);
    check_closed(zoo::hourglass(), true);
    check_closed(zoo::two_triangles(), false);
}
