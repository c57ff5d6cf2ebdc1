#include "exercises/01_traversal/adjacent_faces.h"

#include "course/runner/suite.h"

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
