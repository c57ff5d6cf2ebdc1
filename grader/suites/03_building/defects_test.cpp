// Hidden suite of defects. What is expected is written by hand, or found by
// asking each pair of vertices and each pair of faces.
#include "exercises/03_building/defects.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Defects = std::vector<MeshDefect>;

Defects in_order(Defects list) {
    std::sort(list.begin(), list.end(),
              [](const MeshDefect& x, const MeshDefect& y) {
                  return std::tie(x.fault, x.elements) <
                         std::tie(y.fault, y.elements);
              });
    return list;
}

// ---- the definitions, looked up one by one

bool is_sound(const IndexedMesh& mesh, int f) {
    const FaceList::Face face = mesh.faces[f];
    const std::set<int> corners(face.begin(), face.end());
    return face.size() >= 3 && corners.size() == face.size() &&
           *corners.begin() >= 0 && *corners.rbegin() < mesh.vertex_count();
}

bool has_corner(FaceList::Face face, int v) {
    return std::count(face.begin(), face.end(), v) > 0;
}

/// 1 where the face runs from a to b, -1 where it runs from b to a, else 0.
int runs(FaceList::Face face, int a, int b) {
    for (std::size_t k = 0; k < face.size(); ++k) {
        const int from = face[k];
        const int to = face[k + 1 == face.size() ? 0 : k + 1];
        if (from == a && to == b) return 1;
        if (from == b && to == a) return -1;
    }
    return 0;
}

bool same_face(FaceList::Face x, FaceList::Face y) {
    if (x.size() != y.size()) return false;
    for (std::size_t k = 0; k < x.size(); ++k)
        if (runs(y, x[k], x[k + 1 == x.size() ? 0 : k + 1]) != 1) return false;
    return true;
}

/// The faces that have a corner at v.
std::vector<int> faces_at(const IndexedMesh& mesh, int v,
                          const std::vector<int>& faces) {
    std::vector<int> found;
    for (const int f : faces)
        if (has_corner(mesh.faces[f], v)) found.push_back(f);
    return found;
}

void expect_edge(const IndexedMesh& mesh, int a, int b,
                 const std::vector<int>& at_a, Defects& expected) {
    std::vector<int> elements = {a, b};
    int sum = 0;
    for (const int f : at_a)
        if (const int way = runs(mesh.faces[f], a, b); way != 0) {
            elements.push_back(f);
            sum += way;
        }
    if (elements.size() > 4)
        expected.push_back({MeshFault::too_many_faces, elements});
    else if (elements.size() == 4 && sum != 0)
        expected.push_back({MeshFault::wound_alike, elements});
}

/// Whether f and g share an edge that ends at v.
bool share_edge_at(const IndexedMesh& mesh, int f, int g, int v) {
    for (const int w : mesh.faces[f])
        if (w != v && runs(mesh.faces[f], v, w) != 0 &&
            runs(mesh.faces[g], v, w) != 0)
            return true;
    return false;
}

bool is_one_fan(const IndexedMesh& mesh, int v, std::vector<int> rest) {
    std::vector<int> fan = {rest.back()};
    rest.pop_back();
    for (std::size_t k = 0; k < fan.size(); ++k)
        for (std::size_t r = rest.size(); r-- > 0;)
            if (share_edge_at(mesh, fan[k], rest[r], v)) {
                fan.push_back(rest[r]);
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(r));
            }
    return rest.empty();
}

void expect_duplicates(const IndexedMesh& mesh, const std::vector<int>& sound,
                       Defects& expected) {
    std::set<int> done;
    for (const int f : sound) {
        if (done.contains(f)) continue;
        std::vector<int> same;
        for (const int g : sound)
            if (same_face(mesh.faces[f], mesh.faces[g])) same.push_back(g);
        done.insert(same.begin(), same.end());
        if (same.size() > 1)
            expected.push_back({MeshFault::duplicate_faces, same});
    }
}

/// The last four kinds.
Defects of_sound_faces(const IndexedMesh& mesh) {
    std::vector<int> sound;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (is_sound(mesh, f)) sound.push_back(f);
    Defects expected;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const std::vector<int> at_v = faces_at(mesh, v, sound);
        for (int w = v + 1; w < mesh.vertex_count(); ++w)
            expect_edge(mesh, v, w, at_v, expected);
        if (!at_v.empty() && !is_one_fan(mesh, v, at_v))
            expected.push_back({MeshFault::several_fans, {v}});
    }
    expect_duplicates(mesh, sound, expected);
    return expected;
}

void check_defects(const Fixture& fixture, const Defects& expected) {
    const OnMesh on(fixture);
    CHECK(in_order(::defects(fixture.mesh)) == in_order(expected));
}

void check_none(const Fixture& fixture, std::uint64_t salt = 1) {
    check_defects(fixture, {});
    check_defects(hidden::put_in_another_order(fixture, salt), {});
}

/// Sound faces: as they are, and put down in other ways.
void check_ways(const Fixture& fixture, std::uint64_t salt = 1) {
    check_defects(fixture, of_sound_faces(fixture.mesh));
    for (std::uint64_t k = 0; k < 300; k += 100) {
        const Fixture other = hidden::put_in_another_order(fixture, salt + k);
        check_defects(other, of_sound_faces(other.mesh));
    }
}

/// The faces of the mesh, then these.
Fixture with_faces(const Fixture& fixture,
                   const std::vector<std::vector<int>>& more) {
    IndexedMesh mesh = fixture.mesh;
    for (const std::vector<int>& face : more) mesh.faces.push_back(face);
    return hidden::of_mesh(fixture.name + " and more faces", mesh);
}

}  // namespace

TEST_CASE("sound meshes have no defect", "[points:2]") {
    hint("Which of the seven kinds do you report, and is it true?");
    check_defects(hidden::of_mesh("nothing", {}), {});
    check_defects(hidden::of_mesh("points", {std::vector<Vec3>(4), {}, {}}),
                  {});
    for (const Fixture& fixture :
         {zoo::slide(),          zoo::triangle(),       zoo::tetra(),
          zoo::cube(),           zoo::house(),          zoo::annulus(),
          zoo::torus7(),         zoo::pillow(),         zoo::lens(),
          zoo::fan6(),           zoo::two_triangles(),  zoo::dangling(),
          hidden::twelve_gon(),  hidden::prism(),       hidden::bipyramid(),
          hidden::ring_of_two(), hidden::ring_closed(), hidden::gaps(),
          hidden::two_tori(),    hidden::bridge(),      hidden::loose_chain()})
        check_none(fixture);
}

TEST_CASE("faces with too few corners", "[points:1]") {
    hint("How many corners has a face at least, and can it have none?");
    using enum MeshFault;
    check_defects(with_faces(zoo::slide(), {{3, 4}, {2}, {}}),
                  {{too_few_corners, {3}},
                   {too_few_corners, {4}},
                   {too_few_corners, {5}}});
    check_defects(hidden::of_faces("a 2-gon first", 4, {{0, 1}, {1, 2, 3}}),
                  {{too_few_corners, {0}}});
    check_defects(hidden::of_faces("nothing else", 0, {{}}),
                  {{too_few_corners, {0}}});
}

TEST_CASE("corners that are no vertex", "[points:1]") {
    hint("Which numbers are vertices? Is each wrong corner in your list?");
    using enum MeshFault;
    check_defects(
        with_faces(zoo::slide(),
                   {{3, 6, 4}, {-1, 3, 4}, {4, 7, 3, -5}, {3, 4, 1 << 30}}),
        {{index_out_of_range, {3, 1}},
         {index_out_of_range, {4, 0}},
         {index_out_of_range, {5, 1}},
         {index_out_of_range, {5, 3}},
         {index_out_of_range, {6, 2}}});
    check_defects(hidden::of_faces("no vertices", 0, {{0, 1, 2}}),
                  {{index_out_of_range, {0, 0}},
                   {index_out_of_range, {0, 1}},
                   {index_out_of_range, {0, 2}}});
    check_defects(
        hidden::of_faces("wrong one first", 4, {{4, 1, 2}, {3, 2, 1}}),
        {{index_out_of_range, {0, 0}}});
}

TEST_CASE("a vertex at two corners of a face", "[points:1]") {
    hint("Must the two corners follow each other? Is each number named once?");
    using enum MeshFault;
    check_defects(with_faces(zoo::slide(), {{3, 3, 4},
                                            {3, 4, 3, 0},
                                            {4, 3, 0, 4},
                                            {4, 4, 4},
                                            {0, 3, 0, 3, 4, 0}}),
                  {{repeated_vertex, {3, 3}},
                   {repeated_vertex, {4, 3}},
                   {repeated_vertex, {5, 4}},
                   {repeated_vertex, {6, 4}},
                   {repeated_vertex, {7, 0}},
                   {repeated_vertex, {7, 3}}});
}

TEST_CASE("a face with several defects of its own", "[points:1]") {
    hint("One defect of a face is found. Do you look for more in it?");
    using enum MeshFault;
    check_defects(
        with_faces(zoo::slide(), {{5, 5}, {9}, {-1, -1}, {8, 3, 8, 3}}),
        {{too_few_corners, {3}},
         {repeated_vertex, {3, 5}},
         {too_few_corners, {4}},
         {index_out_of_range, {4, 0}},
         {too_few_corners, {5}},
         {index_out_of_range, {5, 0}},
         {index_out_of_range, {5, 1}},
         {repeated_vertex, {5, -1}},
         {index_out_of_range, {6, 0}},
         {index_out_of_range, {6, 2}},
         {repeated_vertex, {6, 8}},
         {repeated_vertex, {6, 3}}});
}

TEST_CASE("unsound faces take no part in the rest", "[points:1]") {
    hint("Does a face that is none count at an edge, or at a vertex?");
    using enum MeshFault;
    check_defects(with_faces(zoo::cube(), {{0, 1, 0}, {0, 1, 99}, {0, 1}}),
                  {{repeated_vertex, {6, 0}},
                   {index_out_of_range, {7, 2}},
                   {too_few_corners, {8}}});
    check_defects(
        hidden::of_faces("a fan with a gap", 5,
                         {{0, 1, 2}, {0, 2, 3, 2}, {0, 3, 4}, {0, 2, 2, 3}}),
        {{repeated_vertex, {1, 2}},
         {repeated_vertex, {3, 2}},
         {several_fans, {0}}});
    check_defects(hidden::of_faces("twice, but no face", 3,
                                   {{0, 1, 5}, {0, 1, 5}, {0, 1, 2}}),
                  {{index_out_of_range, {0, 2}}, {index_out_of_range, {1, 2}}});
}

TEST_CASE("more than two faces at an edge", "[points:2]") {
    hint("Are all faces of the edge in your list, and is it there once?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        for (const Fixture& fixture : {zoo::fan3(), zoo::house_with_wall()})
            check_ways(fixture, salt);
        check_ways(hidden::with_faces_reversed(zoo::fan3(), {0, 2}), salt);
        check_ways(hidden::of_faces(
                       "five pages", 7,
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 0, 1}, {0, 6, 1}}),
                   salt);
    }
}

TEST_CASE("two faces wound alike", "[points:2]") {
    hint("Which way does each face run along their common edge?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        for (const Fixture& fixture :
             {zoo::moebius3q(), zoo::moebius5(), zoo::klein4x4(), zoo::rp2_6()})
            check_ways(fixture, salt);
        for (int f = 0; f < 6; ++f)
            check_ways(hidden::with_faces_reversed(zoo::cube(), {f}), salt);
        check_ways(hidden::with_faces_reversed(zoo::slide(), {1}), salt);
        check_ways(hidden::with_faces_reversed(zoo::lens(), {0}), salt);
    }
}

TEST_CASE("the same face twice", "[points:2]") {
    hint("May a face begin at another corner? Is its reverse the same face?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        check_ways(hidden::of_faces("twice", 3, {{0, 1, 2}, {1, 2, 0}}), salt);
        check_ways(hidden::of_faces("and reversed", 4,
                                    {{0, 1, 2}, {2, 1, 0}, {2, 0, 1}}),
                   salt);
        check_ways(hidden::of_faces("three times", 4,
                                    {{3, 0, 1, 2}, {0, 1, 2, 3}, {2, 3, 0, 1}}),
                   salt);
        check_ways(hidden::of_faces("same corners, other order", 4,
                                    {{0, 1, 2, 3}, {0, 2, 1, 3}}),
                   salt);
        check_ways(hidden::of_faces("corner left out", 5,
                                    {{0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2, 3, 4}}),
                   salt);
        const Fixture cube = zoo::cube();
        const FaceList::Face second = cube.mesh.faces[2];
        const FaceList::Face last = cube.mesh.faces[5];
        check_ways(with_faces(cube, {{second.begin(), second.end()},
                                     {last.begin(), last.end()}}),
                   salt);
    }
}

TEST_CASE("vertices with more than one fan", "[points:2]") {
    hint("From one face at the vertex, can you come to all the others there?");
    for (std::uint64_t salt = 0; salt < 3; ++salt) {
        for (const Fixture& fixture : {zoo::bow_tie_crossed(), zoo::hourglass(),
                                       hidden::pinwheel_in_turn()})
            check_ways(fixture, salt);
        check_ways(
            hidden::of_faces("pages and a triangle", 7,
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 5, 6}}),
            salt);
        check_ways(
            hidden::of_faces("octahedron, every other face", 6,
                             {{0, 2, 4}, {1, 4, 3}, {1, 2, 5}, {0, 5, 3}}),
            salt);
        check_ways(hidden::of_faces("a common edge, but not at 0", 6,
                                    {{0, 1, 2, 3}, {0, 4, 2, 1, 5}}),
                   salt);
        check_ways(hidden::of_faces("two vertices in common", 6,
                                    {{0, 1, 2, 3}, {0, 4, 2, 5}}),
                   salt);
        check_ways(hidden::with_faces_reversed(zoo::hourglass(), {1, 6}), salt);
    }
}

TEST_CASE("generated meshes, sound and spoilt", "[points:2]") {
    hint("Try your answer by hand: is each defect true, and is none missing?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_open()) {
        check_ways(fixture, ++salt);
        const int n = fixture.mesh.faces.size();
        const FaceList::Face first = fixture.mesh.faces[0];
        const FaceList::Face last = fixture.mesh.faces[n - 1];
        check_ways(with_faces(hidden::with_faces_reversed(fixture, {0, n / 2}),
                              {{last.begin(), last.end()},
                               {first[0], first[1],
                                last[0] == first[0] || last[0] == first[1]
                                    ? first[2]
                                    : last[0]}}),
                   salt);
    }
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How do you find the faces of an edge, and the edges of a vertex?");
    Fixture large = hidden::put_in_another_order(
        hidden::of_mesh("large grid", grid(110, 90)), 5);
    const int n = large.mesh.faces.size();
    large.mesh.faces.push_back(large.mesh.faces[7]);
    const Defects found = ::defects(large.mesh);
    REQUIRE(found.size() >= 5);
    REQUIRE(found.size() <= 9);
    const MeshDefect twice{MeshFault::duplicate_faces, {7, n}};
    CHECK(std::count(found.begin(), found.end(), twice) == 1);
}
