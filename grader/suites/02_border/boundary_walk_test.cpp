// Hidden suite of boundary_walk.
#include "exercises/02_border/boundary_walk.h"

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/walk_checks.h"
#include "grader/suites/meshes.h"

using namespace course;

TEST_CASE("from every half-edge on a border, its own loop", "[points:2]") {
    hint(
        "When are you round? Is the half-edge that you began with in the "
        "list?");
    for (const Fixture& fixture : hidden::made_by_hand())
        walk_checks::from_the_border(boundary_walk, fixture);
}

TEST_CASE("from the side of the face, the loop across the edge", "[points:1]") {
    hint("You stand on the side with a face. Where is the border from here?");
    for (const Fixture& fixture : hidden::made_by_hand())
        walk_checks::from_beside_the_border(boundary_walk, fixture);
}

TEST_CASE("from an edge between two faces there is nothing to walk",
          "[points:1]") {
    hint("What if the other side of the edge has a face, too?");
    for (const Fixture& fixture : hidden::made_by_hand())
        walk_checks::from_within(boundary_walk, fixture);
}

TEST_CASE("loose edges are passed on both sides", "[points:1]") {
    hint("At the end of a loose edge, where does next lead?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty())
            walk_checks::from_everywhere(boundary_walk, fixture);
}

TEST_CASE("numbers of half-edges and faces mean nothing", "[points:1]") {
    hint("Is the next half-edge of the border also the next one in the table?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        walk_checks::from_everywhere(boundary_walk, fixture);
    on_generated_meshes(
        hidden::generated_borders(), [](const Fixture& fixture) {
            walk_checks::from_everywhere(boundary_walk, fixture);
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("Which half-edges does the walk need, and which did you look at?");
    walk_checks::cost(boundary_walk);
}
