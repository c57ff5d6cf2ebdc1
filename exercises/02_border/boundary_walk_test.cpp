#include "exercises/02_border/boundary_walk.h"

#include "course/runner/border_by_faces.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the border of the slide mesh, from its own half-edges",
          "[points:1]") {
    hint(
        "When are you round? Is the half-edge that you began with in the "
        "list?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(boundary_walk(slide.he, 0), IsRotationOf({0, 2, 6, 7, 10, 13}));
    CHECK_THAT(boundary_walk(slide.he, 7), IsRotationOf({0, 2, 6, 7, 10, 13}));
}

TEST_CASE("the same border, from half-edges of the faces beside it",
          "[points:1]") {
    hint("You stand on the side with a face. Where is the border from here?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(boundary_walk(slide.he, 1), IsRotationOf({0, 2, 6, 7, 10, 13}));
    CHECK_THAT(boundary_walk(slide.he, 15), IsRotationOf({0, 2, 6, 7, 10, 13}));
}

TEST_CASE("only edges on the border have a border to walk", "[points:1]") {
    hint("Which edges have a face on both sides, and which on neither?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK(boundary_walk(dangling.he, 3) == std::vector<int>{});
    CHECK(boundary_walk(dangling.he, 11) == std::vector<int>{});
    CHECK(boundary_walk(dangling.he, 16).size() == 8);
}

TEST_CASE("border walks, on generated meshes", "[points:1]") {
    hint("A mesh may have several loops. How do you come to the right one?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        const oracle::Border border(mesh);
        const AskAhead ahead(mesh.he, all_half_edges(mesh.he));
        for (int i = 0; i < mesh.he.size(); ++i)
            REQUIRE_THAT(boundary_walk(mesh.he, i),
                         IsRotationOf(border.walk(i)));
    });
}
