// Hidden suite of boundary_walk_bug.
#include "exercises/02_border/boundary_walk_bug.h"

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/walk_checks.h"
#include "grader/suites/meshes.h"

using namespace course;

TEST_CASE("from every half-edge on a border, its own loop", "[points:2]") {
    hint("Which variable does the condition of the loop look at?");
    for (const Fixture& fixture : hidden::made_by_hand())
        walk_checks::from_the_border(boundary_walk_bug, fixture);
}

TEST_CASE("from the side of the face, the loop across the edge", "[points:1]") {
    hint("How often does the loop run, and how often should it?");
    for (const Fixture& fixture : hidden::made_by_hand())
        walk_checks::from_beside_the_border(boundary_walk_bug, fixture);
}

TEST_CASE("closed components beside an open one", "[points:1]") {
    hint("The lines above the loop were right. Did you change them?");
    walk_checks::from_everywhere(boundary_walk_bug, hidden::open_then_closed());
    walk_checks::from_everywhere(boundary_walk_bug, hidden::closed_then_open());
}

TEST_CASE("loose edges are passed on both sides", "[points:1]") {
    hint("At the end of a loose edge, where does next lead?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty())
            walk_checks::from_everywhere(boundary_walk_bug, fixture);
}

TEST_CASE("numbers of half-edges and faces mean nothing", "[points:1]") {
    hint("What value has the variable in its own first line?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        walk_checks::from_everywhere(boundary_walk_bug, fixture);
    on_generated_meshes(
        hidden::generated_borders(), [](const Fixture& fixture) {
            walk_checks::from_everywhere(boundary_walk_bug, fixture);
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("Which half-edges does the walk need, and which did you look at?");
    walk_checks::cost(boundary_walk_bug);
}
