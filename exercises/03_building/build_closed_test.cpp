#include "exercises/03_building/build_closed.h"

#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a tetrahedron", "[points:1]") {
    hint("Which half-edge runs between the same vertices the other way?");
    const Fixture tetra = zoo::tetra();
    const OnMesh on(tetra);
    CHECK_THAT(build_closed(tetra.mesh), IsTableOf(tetra.mesh));
}

TEST_CASE("a house of quads and triangles", "[points:1]") {
    hint("Where does the last side of a face lead, if the face has four?");
    const Fixture house = zoo::house();
    const OnMesh on(house);
    CHECK_THAT(build_closed(house.mesh), IsTableOf(house.mesh));
}
