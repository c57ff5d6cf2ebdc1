#include "exercises/06_geometry/signed_volume.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the cube, and the tetrahedron of the lecture", "[points:1]") {
    hint("What is the volume of the pyramid over one face, and its sign?");
    const Fixture cube = zoo::cube();
    const OnMesh on(cube);
    CHECK_THAT(signed_volume(cube.mesh), IsAbout(1));
    const Fixture tetra = zoo::tetra();
    const OnMesh on_tetra(tetra);
    CHECK_THAT(signed_volume(tetra.mesh), IsAbout(-8 / 3.0));
}

TEST_CASE("nothing inside", "[points:1]") {
    hint("What is there to add up?");
    const Fixture pillow = zoo::pillow();
    const OnMesh on(pillow);
    CHECK_THAT(signed_volume(pillow.mesh), IsAbout(0, 1));
    CHECK_THAT(signed_volume(IndexedMesh{}), IsAbout(0, 1));
}
