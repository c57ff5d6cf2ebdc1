// Hidden suite of to_soup.
#include "exercises/05_structures/to_soup.h"

#include <cmath>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/05_structures/structures_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

IndexedMesh one_face(std::initializer_list<int> corners) {
    IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {}};
    mesh.faces.push_back(corners);
    return mesh;
}

/// The tetrahedron with its faces, then this one.
IndexedMesh tetra_and(std::initializer_list<int> corners) {
    IndexedMesh mesh = zoo::tetra().mesh;
    mesh.faces.push_back(corners);
    return mesh;
}

}  // namespace

TEST_CASE("each triangle with its own corners, in their order", "[points:2]") {
    hint("In which order do the corners of a face come, and from which on?");
    const IndexedMesh tetra = zoo::tetra().mesh;
    const Vec3 a{-1, -1, -1}, b{1, 1, -1}, c{1, -1, 1}, d{-1, 1, 1};
    const Soup expected = {{{b, c, d}}, {{b, a, c}}, {{d, c, a}}, {{a, b, d}}};
    CHECK(to_soup(tetra) == expected);
    for (const auto& fixtures :
         {hidden::triangle_meshes(), hidden::generated_triangle_meshes()})
        for (const Fixture& fixture : fixtures) {
            const OnMesh on(fixture);
            REQUIRE(to_soup(fixture.mesh) == hidden::torn(fixture.mesh));
        }
}

TEST_CASE("unused vertices, loose edges, and meshes that have no table",
          "[points:1]") {
    hint("Does a vertex that no face names, or a loose edge, give a triangle?");
    for (const Fixture& fixture : {zoo::fan3(), zoo::moebius5(), zoo::rp2_6()})
        CHECK(to_soup(fixture.mesh) == hidden::torn(fixture.mesh));
    IndexedMesh mesh = zoo::tetra().mesh;
    mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});
    mesh.positions.push_back({8, 8, 8});
    mesh.loose_edges = {{0, 5}, {1, 5}};
    mesh.faces = {{1, 3, 2}, {4, 2, 3}, {1, 3, 2}, {2, 2, 2}};
    CHECK(to_soup(mesh) == hidden::torn(mesh));
    mesh.faces = {};
    CHECK(to_soup(mesh).empty());
    CHECK(to_soup(IndexedMesh()).empty());
}

TEST_CASE("coordinates stay as they are", "[points:1]") {
    hint("Is anything to be computed here?");
    IndexedMesh mesh = one_face({2, 0, 3});
    mesh.positions[0] = {1e-300, -1e300, std::nextafter(1.0, 2.0)};
    mesh.positions[2] = {0.1, 1.0 / 3, 16777217};
    mesh.positions[3] = {-0.1, 123456789.123456789, 5e-324};
    CHECK(to_soup(mesh) == hidden::torn(mesh));
}

TEST_CASE("faces that are no triangles are refused", "[points:1]") {
    hint("How many corners may a face have here, and how few?");
    for (const IndexedMesh& mesh :
         {one_face({}), one_face({0}), one_face({0, 1}), one_face({0, 1, 2, 3}),
          tetra_and({0, 1, 2, 3}), tetra_and({2, 1}), tetra_and({}),
          zoo::cube().mesh, zoo::house().mesh, zoo::lens().mesh,
          tetra_and({0, 1, 2, 9}), one_face({7, 8})})
        CHECK_THROWS_AS(to_soup(mesh), std::invalid_argument);
    IndexedMesh four_and_two = tetra_and({0, 1, 2, 3});
    four_and_two.faces.push_back({2, 1});
    CHECK_THROWS_AS(to_soup(four_and_two), std::invalid_argument);
    IndexedMesh both = tetra_and({0, 1, 4});
    both.faces.push_back({0, 1, 2, 3});
    CHECK_THROWS_AS(to_soup(both), std::invalid_argument);
}

TEST_CASE("corners that are no vertices are refused", "[points:1]") {
    hint("Which numbers are vertices of the mesh?");
    for (const int none : {-1, -2, 4, 5, 1 << 30, -(1 << 30)}) {
        CHECK_THROWS_AS(to_soup(one_face({none, 1, 2})), std::out_of_range);
        CHECK_THROWS_AS(to_soup(one_face({0, none, 2})), std::out_of_range);
        CHECK_THROWS_AS(to_soup(one_face({0, 1, none})), std::out_of_range);
        CHECK_THROWS_AS(to_soup(tetra_and({0, 1, none})), std::out_of_range);
    }
    CHECK(to_soup(one_face({3, 2, 0})).size() == 1);
}
