// Hidden suite of report_defects. Reports are written out by hand for small
// meshes, and found by comparing all faces with all others for larger ones.
#include "exercises/09_processing/report_defects.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/defect_oracle.h"
#include "grader/suites/09_processing/face_lists.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Edges = std::vector<std::array<int, 2>>;

/// A mesh by its faces alone: where its vertices lie does not matter.
Fixture of_faces(const std::string& name, int vertices, FaceList faces) {
    IndexedMesh mesh{{}, std::move(faces), {}};
    for (int v = 0; v < vertices; ++v)
        mesh.positions.push_back({v % 4 * 1.0, v / 4 * 1.0, v % 3 * 0.5});
    return {name, std::move(mesh), {}};
}

void check_report(const Fixture& fixture, const DefectReport& expected) {
    const OnMesh on(fixture);
    const DefectReport got = report_defects(fixture.mesh);
    CHECK(got.degenerate_faces == expected.degenerate_faces);
    CHECK(got.duplicate_faces == expected.duplicate_faces);
    CHECK(got.non_manifold_edges == expected.non_manifold_edges);
    CHECK(got.badly_oriented_edges == expected.badly_oriented_edges);
    CHECK(got.non_manifold_vertices == expected.non_manifold_vertices);
    CHECK(got.isolated_vertices == expected.isolated_vertices);
    CHECK(got.borders == expected.borders);
    CHECK(got.components == expected.components);
}

void check_report(const Fixture& fixture) {
    check_report(fixture, oracle::all_defects(fixture.mesh));
}

Fixture cut_out(const std::string& name, const IndexedMesh& mesh,
                const std::vector<int>& holes) {
    FaceList faces;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (std::find(holes.begin(), holes.end(), f) == holes.end())
            faces.push_back(mesh.faces[f]);
    return {name, {mesh.positions, faces, {}}, {}};
}

Fixture with_faces(Fixture fixture, const FaceList& more) {
    for (const FaceList::Face face : more) fixture.mesh.faces.push_back(face);
    fixture.he = {};
    return fixture;
}

}  // namespace

TEST_CASE("sound meshes: borders and components", "[points:2]") {
    hint("Which edges have one face? How many pieces do they make?");
    for (const Fixture& mesh : hidden::made_by_hand()) check_report(mesh);
    for (const Fixture& mesh : hidden::renumbered_copies()) check_report(mesh);
    on_generated_meshes(generated_fixtures(),
                        [](const Fixture& mesh) { check_report(mesh); });
    check_report(zoo::pillow(), {{}, {}, {}, {}, {}, {}, 0, 1});
    check_report(zoo::two_triangles(), {{}, {}, {}, {}, {}, {}, 2, 2});
    check_report(zoo::torus7(), {{}, {}, {}, {}, {}, {}, 0, 1});
}

TEST_CASE("edges with three faces and more", "[points:2]") {
    hint("Is every edge reported once, and with its smaller vertex first?");
    check_report(
        of_faces("five pages", 7,
                 {{6, 2, 0}, {2, 6, 1}, {6, 2, 3}, {2, 6, 4}, {6, 2, 5}}),
        {{}, {}, {{2, 6}}, {}, {}, {}, 1, 1});
    check_report(
        of_faces(
            "two books", 8,
            {{5, 1, 0}, {5, 1, 2}, {5, 1, 3}, {7, 4, 0}, {7, 4, 6}, {4, 7, 3}}),
        {{}, {}, {{1, 5}, {4, 7}}, {}, {0, 3}, {}, 1, 2});
    for (const Fixture& mesh : {zoo::fan3(), zoo::house_with_wall()})
        for (std::uint64_t k = 0; k < 4; ++k)
            check_report({mesh.name, hidden::shuffled(mesh.mesh, k), {}});
    check_report(with_faces(zoo::tetra(), {{0, 1, 2}}));
    check_report(with_faces(zoo::slide(), {{4, 1, 3}, {5, 2, 0}, {2, 5, 4}}));
}

TEST_CASE("two faces that run along an edge the same way", "[points:2]") {
    hint("In which direction does each of the two run? What if there are 3?");
    Fixture cube = zoo::cube();
    FaceList faces;
    for (int f = 0; f < 6; ++f)
        if (f == 3)
            faces.push_back({5, 7, 6, 4});
        else
            faces.push_back(cube.mesh.faces[f]);
    cube.mesh.faces = faces;
    check_report(cube,
                 {{}, {}, {}, {{4, 5}, {4, 6}, {5, 7}, {6, 7}}, {}, {}, 0, 1});
    check_report(
        zoo::moebius5(),
        {{}, {}, {}, {{0, 1}, {0, 4}, {1, 2}, {2, 3}, {3, 4}}, {}, {}, 1, 1});
    for (const Fixture& mesh : hidden::zoo_without_table()) {
        check_report(mesh);
        check_report({mesh.name, hidden::shuffled(mesh.mesh, 9), {}});
    }
    check_report(
        of_faces("three that run alike", 5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}),
        {{}, {}, {{0, 1}}, {}, {}, {}, 1, 1});
    check_report(of_faces("two quads that share two edges", 5,
                          {{0, 1, 2, 3}, {1, 2, 3, 4}}),
                 {{}, {}, {}, {{1, 2}, {2, 3}}, {}, {}, 1, 1});
}

TEST_CASE("vertices whose faces do not hang together", "[points:3]") {
    hint("Over which edges may you step, to stay at this vertex?");
    check_report(zoo::bow_tie_crossed(), {{}, {}, {}, {}, {0}, {}, 1, 2});
    check_report(hidden::pinwheel_split());
    check_report(hidden::pinched_sphere());
    check_report(of_faces("a fin on one of two fans", 8,
                          {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}, {0, 5, 6}}),
                 {{}, {}, {{0, 2}}, {}, {0}, {7}, 1, 2});
    check_report(of_faces("a fan of pages", 6,
                          {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}, {0, 4, 5}}),
                 {{}, {}, {{0, 2}}, {}, {}, {}, 1, 1});
    check_report(of_faces("a fan with a flipped face", 5,
                          {{0, 1, 2}, {0, 3, 2}, {0, 3, 4}}),
                 {{}, {}, {}, {{0, 2}, {0, 3}}, {}, {}, 1, 1});
    // The two fans at 0 are joined far from 0, by the ring of the others.
    check_report(
        of_faces(
            "a ring that comes to a vertex twice", 7,
            {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 6}, {0, 4, 6}}),
        {{}, {}, {}, {}, {0}, {}, 1, 1});
    check_report(of_faces("two fans at both ends of an edge", 6,
                          {{0, 1, 2}, {0, 3, 4}, {1, 5, 3}}));
    for (int more = 2; more < 6; ++more) {
        FaceList faces;
        for (int k = 0; k < more; ++k)
            faces.push_back({2 * k + 1, 2 * k + 2, 0});
        check_report(of_faces("triangles at one vertex", 2 * more + 1, faces),
                     {{}, {}, {}, {}, {0}, {}, 1, more});
    }
}

TEST_CASE("degenerate faces take part in nothing", "[points:2]") {
    hint("Does an edge, a vertex, a duplicate count that only they have?");
    check_report(
        of_faces("few corners", 6, {{0, 1}, {2}, {}, {3, 4, 5}, {1, 0}}),
        {{0, 1, 2, 4}, {}, {}, {}, {}, {0, 1, 2}, 1, 1});
    check_report(of_faces("a vertex twice", 7,
                          {{0, 1, 0},
                           {1, 2, 2},
                           {3, 3, 3},
                           {4, 5, 4, 6},
                           {0, 1, 2, 3, 1},
                           {5, 6, 4}}),
                 {{0, 1, 2, 3, 4}, {}, {}, {}, {}, {0, 1, 2, 3}, 1, 1});
    check_report(of_faces("degenerate twice", 4,
                          {{0, 1, 1}, {0, 1, 1}, {1, 1, 0}, {1, 2, 3}}),
                 {{0, 1, 2}, {}, {}, {}, {}, {0}, 1, 1});
    check_report(of_faces("a degenerate third page", 5,
                          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4, 1}}),
                 {{2}, {}, {}, {}, {}, {4}, 1, 1});
    check_report(
        of_faces("a degenerate bridge", 6,
                 {{0, 1, 2}, {3, 4, 5}, {1, 2, 1, 3}, {2, 1, 4, 4, 3}}),
        {{2, 3}, {}, {}, {}, {}, {}, 2, 2});
}

TEST_CASE("duplicates are faces in the same cyclic order", "[points:2]") {
    hint("Are (0,1,2) and (2,0,1) the same face? (0,2,1)? And (0,2,1,3)?");
    check_report(
        of_faces(
            "the same again and again", 4,
            {{2, 3, 1}, {3, 1, 2}, {1, 3, 2}, {1, 2, 3}, {3, 2, 1}, {2, 3, 1}}),
        {{}, {1, 3, 4, 5}, {}, {}, {}, {0}, 0, 1});
    check_report(of_faces("quads with the same corners", 4,
                          {{0, 1, 2, 3},
                           {0, 2, 1, 3},
                           {2, 3, 0, 1},
                           {0, 3, 2, 1},
                           {1, 3, 0, 2}}),
                 {{}, {2, 4}, {{0, 3}, {1, 2}}, {}, {}, {}, 2, 1});
    check_report(
        of_faces("duplicates on a border", 4,
                 {{0, 1, 2}, {1, 0, 3}, {1, 2, 0}, {3, 1, 0}, {2, 0, 1}}),
        {{}, {2, 3, 4}, {}, {}, {}, {}, 1, 1});
    check_report(of_faces("a part of a face", 5,
                          {{0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2, 3, 4}}));
    const Fixture torus = zoo::torus7();
    Fixture twice{torus.name, torus.mesh, {}};
    for (int f = 13; f >= 0; --f) {
        const FaceList::Face corners = torus.mesh.faces[f];
        twice.mesh.faces.push_back({corners[2], corners[0], corners[1]});
    }
    check_report(twice,
                 {{},
                  {14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27},
                  {},
                  {},
                  {},
                  {},
                  0,
                  1});
}

TEST_CASE("pieces of border", "[points:2]") {
    hint("Two edges of a border belong together when they share what?");
    const IndexedMesh wall = grid(7, 5);
    check_report(cut_out("windows", wall, {8, 10, 12, 22}),
                 {{}, {}, {}, {}, {}, {}, 5, 1});
    check_report(cut_out("holes that touch", wall, {8, 16, 12, 18, 24}),
                 {{}, {}, {}, {}, {18, 21, 27, 28}, {}, 2, 1});
    check_report(cut_out("a hole that touches the rim", wall, {8, 0, 10}));
    check_report(cut_out("a wall in two", wall, {7, 8, 9, 10, 11, 12, 13}));
    check_report(with_faces(zoo::cube(), {{4, 6, 3}}));
    for (int holes = 1; holes < 5; ++holes) {
        std::vector<int> out;
        for (int k = 0; k < holes; ++k) out.push_back(5 * k);
        check_report(cut_out("icosahedron with holes", icosphere(0), out));
    }
}

TEST_CASE("pieces of the surface", "[points:2]") {
    hint("Do two faces belong together that only share a vertex?");
    check_report(zoo::hourglass(), {{}, {}, {}, {}, {0}, {}, 0, 2});
    check_report(of_faces("two books joined by a page", 8,
                          {{0, 1, 2},
                           {0, 1, 3},
                           {0, 1, 4},
                           {5, 6, 7},
                           {6, 5, 4},
                           {5, 6, 2},
                           {4, 1, 5}}));
    check_report(of_faces("a chain of corners", 9,
                          {{0, 1, 2}, {2, 3, 4}, {4, 5, 6}, {6, 7, 8}}),
                 {{}, {}, {}, {}, {2, 4, 6}, {}, 1, 4});
    check_report(of_faces("pieces in a mixed order", 12,
                          {{0, 4, 8},
                           {1, 5, 9},
                           {2, 6, 10},
                           {3, 7, 11},
                           {8, 4, 2},
                           {9, 5, 3},
                           {2, 10, 8}}),
                 {{}, {}, {}, {}, {3}, {}, 2, 3});
    check_report(hidden::open_then_closed());
    check_report(hidden::two_tori());
}

TEST_CASE("scans with all kinds of defects", "[points:3]") {
    hint("Which defect hides another one, by the definitions?");
    for (std::uint64_t k = 0; k < 24; ++k) check_report(hidden::dirty_scan(k));
}

TEST_CASE("no faces, no vertices, loose edges", "[points:1]") {
    hint("What is there to report when there is nothing?");
    check_report({"nothing", {}, {}}, {});
    check_report(of_faces("three points", 3, {}),
                 {{}, {}, {}, {}, {}, {0, 1, 2}, 0, 0});
    check_report(of_faces("nothing sound", 2, {{0, 1}, {1, 1, 0}}),
                 {{0, 1}, {}, {}, {}, {}, {0, 1}, 0, 0});
    check_report(zoo::dangling(), {{}, {}, {}, {}, {}, {6}, 1, 1});
    check_report(hidden::bridge());
    check_report(hidden::gaps());
}

TEST_CASE("a large mesh takes no longer than sorting it", "[points:1][once]") {
    hint("For one face, how many others do you compare it with?");
    constexpr int triangles = 5000;
    Fixture many = of_faces("many triangles", 3 * triangles, {});
    for (int f = 0; f < triangles; ++f)
        many.mesh.faces.push_back({f, f + triangles, f + 2 * triangles});
    check_report(many, {{}, {}, {}, {}, {}, {}, triangles, triangles});
}
