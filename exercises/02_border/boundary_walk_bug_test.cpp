#include "exercises/02_border/boundary_walk_bug.h"

#include "course/runner/border_by_faces.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the border of the slide mesh, from its own half-edges",
          "[points:1]") {
    hint("How often does the loop run, and why does it stop?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(boundary_walk_bug(slide.he, 0),
               IsRotationOf({0, 2, 6, 7, 10, 13}));
    CHECK_THAT(boundary_walk_bug(slide.he, 7),
               IsRotationOf({0, 2, 6, 7, 10, 13}));
}

TEST_CASE("the same border, from half-edges of the faces beside it",
          "[points:1]") {
    hint("Which variable does each line of the loop mean by i?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(boundary_walk_bug(slide.he, 1),
               IsRotationOf({0, 2, 6, 7, 10, 13}));
    CHECK_THAT(boundary_walk_bug(slide.he, 15),
               IsRotationOf({0, 2, 6, 7, 10, 13}));
}

TEST_CASE("only edges on the border have a border to walk", "[points:1]") {
    hint("The lines above the loop were right. Did you change them?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK(boundary_walk_bug(dangling.he, 3) == std::vector<int>{});
    CHECK(boundary_walk_bug(dangling.he, 11) == std::vector<int>{});
    CHECK(boundary_walk_bug(dangling.he, 16).size() == 8);
}

TEST_CASE("the same walks, on generated meshes", "[points:1]") {
    hint("What value has each variable when the loop begins anew?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        const oracle::Border border(mesh);
        const AskAhead ahead(mesh.he, all_half_edges(mesh.he));
        for (int i = 0; i < mesh.he.size(); ++i)
            REQUIRE_THAT(boundary_walk_bug(mesh.he, i),
                         IsRotationOf(border.walk(i)));
    });
}
