// Hidden suite of orient. Flags are checked by what they bring about; that
// there are none is known of these meshes, or found by trying all.
#include "exercises/04_topology/orient.h"

#include <algorithm>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_orientable(const Fixture& fixture) {
    const OnMesh on(fixture);
    const std::optional<std::vector<bool>> flags = orient(fixture.mesh);
    REQUIRE(flags.has_value());
    REQUIRE(std::ssize(*flags) == fixture.mesh.faces.size());
    INFO("flags: " << show(*flags));
    CHECK(oracle::sides_agree_after(fixture.mesh, *flags));
}

void check_not_orientable(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(orient(fixture.mesh) == std::nullopt);
}

void check_orient(const Fixture& fixture, bool orientable) {
    if (orientable)
        check_orientable(fixture);
    else
        check_not_orientable(fixture);
}

/// Some of its faces turned over, a third of them, as the seed has it.
Fixture some_flipped(const Fixture& fixture, std::uint64_t salt) {
    const int n = fixture.mesh.faces.size();
    std::vector<int> any = hidden::any_order(n, salt);
    any.resize(any.size() / 3);
    return hidden::flipped(fixture, any);
}

/// As it is, with some faces turned over, and that in another order.
void check_mixed(const Fixture& fixture, bool orientable,
                 std::uint64_t salt = 1) {
    check_orient(fixture, orientable);
    check_orient(some_flipped(fixture, salt), orientable);
    check_orient(hidden::shuffled(some_flipped(fixture, salt + 1), salt),
                 orientable);
}

Fixture face_list(const std::string& name, const IndexedMesh& mesh) {
    return hidden::face_list_only(name, mesh);
}

/// A row of quads, left to right.
Fixture row_of_quads(int n) {
    return face_list("row of quads", grid(n, 1));
}

}  // namespace

TEST_CASE("meshes that are oriented already", "[points:1]") {
    hint("If nothing must be turned over, is that what your flags say?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::cube(), zoo::torus7(), zoo::fan6(), zoo::lens(),
          zoo::annulus(), hidden::prism(), hidden::windows(),
          hidden::two_tori()}) {
        check_orientable(fixture);
        std::vector<int> all;
        for (int f = 0; f < fixture.mesh.faces.size(); ++f) all.push_back(f);
        check_orientable(hidden::flipped(fixture, all));
    }
}

TEST_CASE("any one face turned over, and any two", "[points:2]") {
    hint("Does a face that is to be turned over tell its neighbours so?");
    for (const Fixture& fixture : {zoo::cube(), zoo::annulus(), zoo::torus7(),
                                   row_of_quads(7), hidden::prism()}) {
        const int n = fixture.mesh.faces.size();
        for (int f = 0; f < n; ++f) {
            check_orientable(hidden::flipped(fixture, {f}));
            for (int g = 0; g < f; ++g)
                check_orientable(hidden::flipped(fixture, {f, g}));
        }
    }
}

TEST_CASE("faces whose neighbours stand anywhere in the list", "[points:2]") {
    hint("In which order must faces get their flags, and is it the list's?");
    // The search has to come back: 0 2 4 6 5 3 1 and the like.
    for (const int n : {4, 7, 12}) {
        for (std::uint64_t salt = 0; salt < 8; ++salt) {
            const Fixture row = hidden::shuffled(row_of_quads(n), salt);
            check_orientable(row);
            check_orientable(some_flipped(row, salt));
            const Fixture strip = hidden::shuffled(
                face_list("strip", hidden::triangle_strip(n)), salt);
            check_orientable(some_flipped(strip, salt));
        }
        IndexedMesh there_and_back = grid(n, 1);
        const FaceList quads = there_and_back.faces;
        there_and_back.faces = {};
        for (int f = 0; f < n; f += 2) there_and_back.faces.push_back(quads[f]);
        for (int f = n - 1; f > 0; --f)
            if (f % 2 == 1) there_and_back.faces.push_back(quads[f]);
        check_mixed(face_list("there and back", there_and_back), true);
    }
}

TEST_CASE("bands with a twist and without", "[points:2]") {
    hint("The last quad of the ring meets the first one. Do they agree?");
    for (int quads = 3; quads <= 9; ++quads)
        for (std::uint64_t salt = 0; salt < 3; ++salt) {
            check_mixed(face_list("band", hidden::straight_band(quads)), true,
                        salt);
            check_mixed(face_list("twisted band", hidden::twisted_band(quads)),
                        false, salt);
        }
    check_mixed(zoo::moebius5(), false);
}

TEST_CASE("closed surfaces with two sides, and with one", "[points:1]") {
    hint("Is there always a border where the trouble shows?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        check_mixed(zoo::klein4x4(), false, salt);
        check_mixed(face_list("torus", torus(4, 4)), true, salt);
        check_mixed(zoo::rp2_6(), false, salt);
        check_mixed(zoo::house(), true, salt);
        check_mixed(face_list("double torus", hidden::surface_of_genus(2, 1)),
                    true, salt);
    }
}

TEST_CASE("several parts", "[points:2]") {
    hint("One part is done. Which faces have no flag yet?");
    const IndexedMesh band = hidden::straight_band(4);
    const IndexedMesh twisted = hidden::twisted_band(5);
    const IndexedMesh ball = zoo::cube().mesh;
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        check_mixed(zoo::two_triangles(), true, salt);
        check_mixed(hidden::open_then_closed(), true, salt);
        check_mixed(hidden::closed_then_open(), true, salt);
        check_mixed(
            face_list("three parts", hidden::side_by_side({ball, band, ball})),
            true, salt);
        check_mixed(face_list("twist first",
                              hidden::side_by_side({twisted, ball, band})),
                    false, salt);
        check_mixed(face_list("twist between",
                              hidden::side_by_side({band, twisted, ball})),
                    false, salt);
        check_mixed(face_list("twist last",
                              hidden::side_by_side({ball, band, twisted})),
                    false, salt);
        check_mixed(
            face_list("two twists", hidden::side_by_side({twisted, twisted})),
            false, salt);
    }
}

TEST_CASE("faces that share several edges, or a vertex only", "[points:1]") {
    hint("At which edges, and at how many, must two faces agree?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        for (const Fixture& fixture :
             {zoo::pillow(), zoo::lens(), hidden::ring_of_two(),
              hidden::ring_closed(), zoo::bow_tie_crossed(), zoo::hourglass(),
              hidden::pinwheel_across(), hidden::checkered_octahedron(),
              face_list("bag of two", hidden::straight_band(2))})
            check_mixed(fixture, true, salt);
        check_mixed(face_list("band of two", hidden::twisted_band(2)), false,
                    salt);
        const Fixture twisted =
            face_list("twisted band", hidden::twisted_band(6));
        check_mixed(hidden::merged(twisted, 0, 6), false, salt);
    }
}

TEST_CASE("edges with three faces or more", "[points:1]") {
    hint("Do you look at every pair of faces at the edge?");
    const Fixture book = zoo::fan3();
    for (int f = 0; f < 3; ++f) check_mixed(hidden::flipped(book, {f}), false);
    Fixture four = face_list("four pages", book.mesh);
    four.mesh.positions.push_back({1, 1, 1});
    four.mesh.faces.push_back({1, 0, 5});
    check_mixed(four, false);
    check_mixed(zoo::house_with_wall(), false);
    const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    check_mixed(face_list("twice", {corners, {{0, 1, 2}, {1, 2, 0}}, {}}),
                true);
    check_mixed(face_list("three times",
                          {corners, {{0, 1, 2}, {1, 2, 0}, {0, 2, 1}}, {}}),
                false);
    check_mixed(face_list("book beside a cube",
                          hidden::side_by_side({zoo::cube().mesh, book.mesh})),
                false);
}

TEST_CASE("no faces, and edges and vertices of no face", "[points:1]") {
    hint("How many flags has a mesh without faces, and is that an answer?");
    check_orientable(face_list("nothing", {}));
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    check_orientable(face_list("points", {points, {}, {}}));
    check_orientable(face_list("loose edges", {points, {}, {{0, 1}, {1, 2}}}));
    for (const Fixture& fixture : hidden::all_face_lists()) {
        Fixture more = fixture;
        more.mesh.positions.resize(more.mesh.positions.size() + 2);
        if (!fixture.mesh.faces.empty())
            more.mesh.loose_edges = {
                {fixture.mesh.faces[0][0], fixture.mesh.faces[0][1]},
                {fixture.mesh.faces[0][0], fixture.mesh.vertex_count()}};
        if (more.mesh.faces.size() <= 10)
            check_orient(more, oracle::some_flags_agree(more.mesh));
    }
}

TEST_CASE("generated meshes, some faces turned over", "[points:2]") {
    hint("Try the flags on your own mesh: do all neighbours agree?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : generated_fixtures()) {
        check_mixed(fixture, true, ++salt);
        check_mixed(face_list("generated, and a twisted band",
                              hidden::side_by_side(
                                  {fixture.mesh, hidden::twisted_band(4)})),
                    false, ++salt);
    }
    for (std::uint64_t k = 0; k < 4; ++k) {
        RandomMesh options;
        options.faces = 60;
        options.parts = 2;
        options.hole_percent = 15;
        options.bow_ties = BowTies::allowed;
        check_mixed(face_list("generated mesh with holes",
                              random_polygons(seed() * 100 + k, options)),
                    true, ++salt);
    }
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How do you find the neighbours of a face, and how often?");
    check_orientable(
        hidden::shuffled(some_flipped(face_list("grid", grid(55, 50)), 3), 4));
}
