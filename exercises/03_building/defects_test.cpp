#include "exercises/03_building/defects.h"

#include <algorithm>
#include <tuple>

#include "course/runner/suite.h"

using namespace course;

namespace {

std::vector<MeshDefect> in_order(std::vector<MeshDefect> list) {
    std::sort(list.begin(), list.end(),
              [](const MeshDefect& x, const MeshDefect& y) {
                  return std::tie(x.fault, x.elements) <
                         std::tie(y.fault, y.elements);
              });
    return list;
}

}  // namespace

TEST_CASE("a sound mesh has no defect", "[points:1]") {
    hint("What do you report of the slide mesh, and is it true?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(::defects(slide.mesh) == std::vector<MeshDefect>{});
}

TEST_CASE("three triangles at one edge", "[points:1]") {
    hint("Which edge has three faces, and which faces are they?");
    const Fixture fan3 = zoo::fan3();
    const OnMesh on(fan3);
    const std::vector<MeshDefect> found = ::defects(fan3.mesh);
    REQUIRE(found.size() == 1);
    CHECK(found[0].fault == MeshFault::too_many_faces);
    CHECK(found[0].elements.size() == 5);
}

TEST_CASE("a face that is none, and a bow-tie", "[points:1]") {
    hint("Is the first face checked by itself? Do the others form one fan?");
    const IndexedMesh mesh{
        std::vector<Vec3>(5), {{0, 1, 7, 1}, {0, 1, 2}, {0, 3, 4}}, {}};
    CHECK(in_order(::defects(mesh)) ==
          std::vector<MeshDefect>{{MeshFault::index_out_of_range, {0, 2}},
                                  {MeshFault::repeated_vertex, {0, 1}},
                                  {MeshFault::several_fans, {0}}});
}
