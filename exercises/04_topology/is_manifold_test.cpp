#include "exercises/04_topology/is_manifold.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

void check_manifold(const Fixture& fixture, bool expected) {
    const OnMesh on(fixture);
    CHECK(is_manifold(fixture.mesh) == expected);
}

}  // namespace

TEST_CASE("three faces at an edge are too many", "[points:1]") {
    hint("How many faces does each edge have?");
    check_manifold(zoo::slide(), true);
    check_manifold(zoo::fan3(), false);
    check_manifold(zoo::house(), true);
    check_manifold(zoo::house_with_wall(), false);
}

TEST_CASE("two fans at a vertex are too many", "[points:1]") {
    hint("From one face at the vertex, can you reach all its others?");
    check_manifold(zoo::fan6(), true);
    check_manifold(zoo::bow_tie_crossed(), false);
    check_manifold(zoo::torus7(), true);
    check_manifold(zoo::hourglass(), false);
}

TEST_CASE("a surface need not have two sides", "[points:1]") {
    hint("Does the direction in which a face names an edge matter?");
    check_manifold(zoo::moebius5(), true);
    check_manifold(zoo::klein4x4(), true);
    check_manifold(zoo::fan3(), false);
}
