// Hidden suite of build_closed. A table is right when it breaks no rule and has
// the faces of the mesh, however its half-edges are numbered.
#include "exercises/03_building/build_closed.h"

#include "course/mesh/generators.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_build(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK_THAT(build_closed(fixture.mesh), IsTableOf(fixture.mesh));
}

/// As it is, and put down in other ways.
void check_ways(const Fixture& fixture, std::uint64_t salt = 1) {
    check_build(fixture);
    check_build(hidden::put_in_another_order(fixture, salt));
    check_build(hidden::put_in_another_order(fixture, salt + 100));
}

}  // namespace

TEST_CASE("triangles", "[points:2]") {
    hint("Does every half-edge have its opposite, and that one this one?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::torus7(), hidden::bipyramid(),
          hidden::of_mesh("icosphere", icosphere(1)), hidden::double_cone(3),
          hidden::double_cone(4)})
        check_ways(fixture);
}

TEST_CASE("faces of any number of sides", "[points:2]") {
    hint("How many sides has a face, and which row comes after its last?");
    for (const Fixture& fixture :
         {zoo::cube(), zoo::house(), hidden::prism(),
          hidden::of_mesh("torus of quads", torus(5, 4))})
        check_ways(fixture);
}

TEST_CASE("faces that share several edges", "[points:1]") {
    hint("Is the opposite found by faces, or by the two vertices of the edge?");
    for (const Fixture& fixture : {zoo::pillow(), hidden::ring_closed()})
        check_ways(fixture);
    check_ways(hidden::of_faces("pillow of hexagons", 6,
                                {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}}));
}

TEST_CASE("several parts, apart or with a vertex in common", "[points:1]") {
    hint("Do the numbers of the first part get into the second?");
    for (const Fixture& fixture : {zoo::hourglass(), hidden::two_tori()})
        check_ways(fixture);
    check_ways(hidden::beside_each_other(
        {zoo::cube(), zoo::tetra(), zoo::house(), zoo::pillow()}));
}

TEST_CASE("vertices that no face uses, and no faces", "[points:1]") {
    hint("Does each vertex number have a half-edge?");
    CHECK(build_closed({}).empty());
    CHECK(build_closed({std::vector<Vec3>(4), {}, {}}).empty());
    IndexedMesh mesh = zoo::cube().mesh;
    mesh.positions.resize(12);
    check_ways(hidden::of_mesh("cube and four points", mesh));
    mesh = {std::vector<Vec3>(140'000), {}, {}};
    mesh.faces = {
        {0, 65'536, 131'072},  {0, 139'999, 65'536}, {65'536, 139'999, 131'072},
        {131'072, 139'999, 0}, {1, 65'537, 2},       {2, 65'537, 1}};
    CHECK_THAT(build_closed(mesh), IsTableOf(mesh));
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Does your table depend on the order in which the faces come?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_closed())
        check_ways(fixture, ++salt);
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How long does it take to find one opposite?");
    const Fixture large = hidden::put_in_another_order(
        hidden::of_mesh("large torus", torus(110, 100)), 5);
    const std::string why = difference(build_closed(large.mesh), large.mesh);
    CHECK(why.empty());
}
