#include "exercises/01_traversal/adjacent_faces.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("the neighbours of the slide mesh's faces", "[points:2]") {
    hint("On each side of the face: who is across?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(adjacent_faces(slide.he, 1), IsPermutationOf({1}));
    CHECK_THAT(adjacent_faces(slide.he, 4), IsPermutationOf({0, 2}));
    CHECK_THAT(adjacent_faces(slide.he, 15), IsPermutationOf({0, 2}));
    CHECK_THAT(adjacent_faces(slide.he, 9), IsPermutationOf({1}));
}

TEST_CASE("a half-edge on the border has no face, so no neighbours",
          "[points:1]") {
    hint("Each border half-edge has a face across. Is it on a face itself?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(adjacent_faces(slide.he, 0).empty());
    CHECK(adjacent_faces(slide.he, 7).empty());
}

TEST_CASE("the neighbours of faces, on generated meshes", "[points:1]") {
    hint("Two faces may share several edges. How often are they neighbours?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            REQUIRE_THAT(adjacent_faces(he, i),
                         IsPermutationOf(expected.adjacent_faces(i)));
        });
}
