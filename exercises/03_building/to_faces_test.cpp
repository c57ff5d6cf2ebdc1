#include "exercises/03_building/to_faces.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the slide mesh has its three faces back", "[points:1]") {
    hint("Which half-edges belong to face 1, and in which order?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const std::vector<std::vector<int>> faces = ::to_faces(slide.he);
    REQUIRE(faces.size() == 3);
    CHECK_THAT(faces[0], IsRotationOf({0, 2, 1}));
    CHECK_THAT(faces[1], IsRotationOf({1, 2, 5, 4}));
    CHECK_THAT(faces[2], IsRotationOf({2, 3, 5}));
}

TEST_CASE("the border is no face", "[points:1]") {
    hint("Which half-edges run along no face?");
    const Fixture triangle = zoo::triangle();
    const OnMesh on(triangle);
    const std::vector<std::vector<int>> faces = ::to_faces(triangle.he);
    REQUIRE(faces.size() == 1);
    CHECK_THAT(faces[0], IsRotationOf({0, 1, 2}));
}
