// Hidden suite of is_consistently_oriented. A guess is right half the time:
// each case asks for both answers, many times.
#include "exercises/04_topology/is_consistently_oriented.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_oriented(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(is_consistently_oriented(fixture.mesh) ==
          oracle::sides_agree(fixture.mesh));
}

std::vector<int> all_faces(const Fixture& fixture) {
    std::vector<int> faces;
    for (int f = 0; f < fixture.mesh.faces.size(); ++f) faces.push_back(f);
    return faces;
}

}  // namespace

TEST_CASE("any one face turned over", "[points:2]") {
    hint("With which of its neighbours is that face compared?");
    for (const Fixture& fixture :
         {zoo::cube(), zoo::house(), zoo::torus7(), zoo::annulus(), zoo::fan6(),
          hidden::prism(), hidden::windows(), hidden::open_then_closed(),
          hidden::closed_then_open()}) {
        check_oriented(fixture);
        for (const int f : all_faces(fixture))
            check_oriented(hidden::flipped(fixture, {f}));
    }
}

TEST_CASE("all faces turned over, or all of one part", "[points:1]") {
    hint("Does it matter which side is the front, if all agree?");
    for (const Fixture& fixture :
         {zoo::cube(), zoo::torus7(), zoo::lens(), zoo::two_triangles(),
          hidden::two_tori(), hidden::gaps()}) {
        const std::vector<int> faces = all_faces(fixture);
        check_oriented(hidden::flipped(fixture, faces));
        const auto half = faces.begin() + std::ssize(faces) / 2;
        check_oriented(hidden::flipped(fixture, {faces.begin(), half}));
        check_oriented(hidden::flipped(fixture, {half + 1, faces.end()}));
    }
    check_oriented(hidden::flipped(hidden::open_then_closed(), {0}));
    check_oriented(hidden::flipped(hidden::closed_then_open(), {4}));
    check_oriented(hidden::flipped(hidden::closed_then_open(), {3}));
}

TEST_CASE("faces that share two edges or more, or a vertex only",
          "[points:2]") {
    hint("Which pairs of faces must agree, and at which edges?");
    for (const Fixture& fixture :
         {zoo::pillow(), zoo::lens(), hidden::ring_of_two(),
          hidden::ring_closed(), zoo::bow_tie_crossed(), zoo::hourglass(),
          hidden::pinwheel_across(), hidden::checkered_octahedron(),
          hidden::face_list_only("band of two", hidden::twisted_band(2)),
          hidden::face_list_only("bag of two", hidden::straight_band(2))})
        for (const std::vector<int>& turned :
             {std::vector<int>{}, std::vector<int>{0}, std::vector<int>{1},
              std::vector<int>{0, 1}}) {
            check_oriented(hidden::flipped(fixture, turned));
            check_oriented(
                hidden::shuffled(hidden::flipped(fixture, turned), 3));
        }
}

TEST_CASE("surfaces that have two sides, and that have one", "[points:1]") {
    hint("Does the first face of the ring agree with the last one?");
    for (int quads = 3; quads <= 8; ++quads)
        for (const IndexedMesh& mesh :
             {hidden::straight_band(quads), hidden::twisted_band(quads)}) {
            const Fixture band = hidden::face_list_only("band", mesh);
            check_oriented(band);
            check_oriented(hidden::shuffled(band, 7));
        }
    check_oriented(zoo::rp2_6());
    check_oriented(zoo::klein4x4());
}

TEST_CASE("edges with three faces or more", "[points:1]") {
    hint("How can three faces run along one edge, two at a time?");
    const Fixture book = zoo::fan3();
    for (const std::vector<int>& turned :
         {std::vector<int>{}, std::vector<int>{0}, std::vector<int>{1},
          std::vector<int>{2}, std::vector<int>{0, 1}, std::vector<int>{1, 2}})
        check_oriented(hidden::flipped(book, turned));
    check_oriented(zoo::house_with_wall());
    Fixture four = hidden::face_list_only("four pages", book.mesh);
    four.mesh.positions.push_back({1, 1, 1});
    four.mesh.faces.push_back({1, 0, 5});
    check_oriented(four);
    // The same corners twice, wound alike and not.
    const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    check_oriented(
        hidden::face_list_only("twice", {corners, {{0, 1, 2}, {1, 2, 0}}, {}}));
    check_oriented(
        hidden::face_list_only("twice", {corners, {{0, 1, 2}, {2, 1, 0}}, {}}));
}

TEST_CASE("no faces, and edges and vertices of no face", "[points:1]") {
    hint("What is there to disagree when there is only one face, or none?");
    CHECK(is_consistently_oriented(IndexedMesh()));
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(is_consistently_oriented({points, {}, {}}));
    CHECK(is_consistently_oriented({points, {}, {{0, 1}, {1, 2}}}));
    for (const Fixture& fixture : hidden::all_face_lists()) {
        Fixture more = fixture;
        more.mesh.positions.resize(more.mesh.positions.size() + 3);
        check_oriented(more);
        if (fixture.mesh.faces.empty()) continue;
        more.mesh.loose_edges = {
            {fixture.mesh.faces[0][0], fixture.mesh.faces[0][1]}};
        check_oriented(more);
    }
}

TEST_CASE("generated meshes, some faces turned over", "[points:2]") {
    hint(
        "Where a face begins, and where it stands in the list: do they "
        "matter?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : generated_fixtures())
        for (int k = 0; k < 4; ++k) {
            const Fixture mixed = hidden::shuffled(fixture, ++salt);
            check_oriented(mixed);
            const std::vector<int> any =
                hidden::any_order(mixed.mesh.faces.size(), salt);
            check_oriented(
                hidden::flipped(mixed, {any.begin(), any.begin() + 1 + k}));
        }
}

TEST_CASE("a large mesh, and the same with one face turned over",
          "[points:1][once]") {
    hint("How many sides is each side compared with?");
    const Fixture large =
        hidden::shuffled(hidden::face_list_only("grid", grid(70, 60)), 11);
    CHECK(is_consistently_oriented(large.mesh));
    CHECK_FALSE(is_consistently_oriented(hidden::flipped(large, {4199}).mesh));
}
