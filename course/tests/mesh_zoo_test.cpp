// The mesh zoo against the counts that are known of each fixture.
#include "course/mesh/zoo.h"

#include <algorithm>
#include <array>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_counts.h"

namespace {

using namespace course;
using namespace course::brute;

/// Counts worked out by hand; `loops` are the lengths of the border loops.
struct Expected {
    Fixture (*make)();
    const char* name;
    int vertices, edges, faces, euler;
    std::vector<int> loops;
};

const std::vector<Expected> with_tables = {
    {zoo::slide, "slide", 6, 8, 3, 1, {6}},
    {zoo::triangle, "triangle", 3, 3, 1, 1, {3}},
    {zoo::tetra, "tetra", 4, 6, 4, 2, {}},
    {zoo::cube, "cube", 8, 12, 6, 2, {}},
    {zoo::house, "house", 9, 16, 9, 2, {}},
    {zoo::annulus, "annulus", 6, 9, 3, 0, {3, 3}},
    {zoo::torus7, "torus7", 7, 21, 14, 0, {}},
    {zoo::pillow, "pillow", 3, 3, 2, 2, {}},
    {zoo::lens, "lens", 5, 6, 2, 1, {4}},
    {zoo::fan6, "fan6", 7, 12, 6, 1, {6}},
    {zoo::two_triangles, "two_triangles", 6, 6, 2, 2, {3, 3}},
    {zoo::dangling, "dangling", 7, 9, 3, 1, {8}},
    {zoo::bow_tie_crossed, "bow_tie_crossed", 5, 6, 2, 1, {6}},
    {zoo::bow_tie_separate, "bow_tie_separate", 5, 6, 2, 1, {3, 3}},
    {zoo::hourglass, "hourglass", 7, 12, 8, 3, {}},
};

/// `border` is the number of edges that have one face.
struct ExpectedWithout {
    Fixture (*make)();
    const char* name;
    int vertices, edges, faces, euler, border;
    std::vector<DefectKind> defects;
};

const auto alike = DefectKind::faces_wound_alike;
const auto crowded = DefectKind::edge_with_many_faces;

const std::vector<ExpectedWithout> without_tables = {
    {zoo::moebius3q, "moebius3q", 6, 9, 3, 0, 6, {alike}},
    {zoo::moebius5, "moebius5", 5, 10, 5, 0, 5, {alike}},
    {zoo::klein4x4, "klein4x4", 16, 32, 16, 0, 0, {alike}},
    {zoo::rp2_6, "rp2_6", 6, 15, 10, 1, 0, {alike}},
    {zoo::fan3, "fan3", 5, 7, 3, 1, 6, {crowded}},
    {zoo::house_with_wall, "house_with_wall", 9, 16, 10, 3, 0, {crowded}},
};

int edge_count(const IndexedMesh& mesh) {
    return static_cast<int>(edges_of(mesh).size());
}

/// A face turned so that its smallest vertex comes first.
std::vector<int> turned(FaceList::Face face) {
    std::vector<int> corners(face.begin(), face.end());
    std::rotate(corners.begin(),
                std::min_element(corners.begin(), corners.end()),
                corners.end());
    return corners;
}

/// The vertices that a walk round a vertex meets: opp, then next.
std::vector<int> star(const HalfEdgeTable& he, int start) {
    std::vector<int> vertices;
    int i = start;
    do {
        i = he[i].opp;
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

std::vector<DefectKind> kinds_of(const IndexedMesh& mesh) {
    std::vector<DefectKind> kinds;
    for (const Defect& defect : defects(mesh))
        if (kinds.empty() || kinds.back() != defect.kind)
            kinds.push_back(defect.kind);
    return kinds;
}

double signed_area(const IndexedMesh& mesh, int f) {
    const auto face = mesh.faces[f];
    double sum = 0;
    for (std::size_t k = 0; k < face.size(); ++k)
        sum += cross(mesh.positions[at(face[k])],
                     mesh.positions[at(face[(k + 1) % face.size()])])
                   .z;
    return sum / 2;
}

bool is_flat(const IndexedMesh& mesh) {
    return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                       [](Vec3 p) { return p.z == 0; });
}

}  // namespace

TEST_CASE("each fixture has the counts that were worked out by hand") {
    for (const Expected& expected : with_tables) {
        const Fixture fixture = expected.make();
        CAPTURE(expected.name);
        CHECK(fixture.name == expected.name);
        CHECK(fixture.mesh.vertex_count() == expected.vertices);
        CHECK(vertices_of(fixture.mesh) == expected.vertices);
        CHECK(edge_count(fixture.mesh) == expected.edges);
        CHECK(fixture.mesh.faces.size() == expected.faces);
        CHECK(euler_of(fixture.mesh) == expected.euler);
        CHECK(fixture.he.size() == 2 * expected.edges);
        CHECK(loops_of(fixture.he) == expected.loops);
    }
}

TEST_CASE("each table of the zoo is sound and has the faces of its mesh") {
    for (const Expected& expected : with_tables) {
        const Fixture fixture = expected.make();
        CAPTURE(expected.name);
        CHECK(validate(fixture.he).empty());
        const FaceList faces = to_faces(fixture.he);
        REQUIRE(faces.size() == fixture.mesh.faces.size());
        for (int f = 0; f < faces.size(); ++f)
            CHECK(turned(faces[f]) == turned(fixture.mesh.faces[f]));
        CHECK(loose_edges(fixture.he) == fixture.mesh.loose_edges);
    }
}

TEST_CASE("the fixtures without a table have their counts and their defects") {
    for (const ExpectedWithout& expected : without_tables) {
        const Fixture fixture = expected.make();
        CAPTURE(expected.name);
        CHECK(fixture.name == expected.name);
        CHECK(fixture.he.empty());
        CHECK(fixture.mesh.vertex_count() == expected.vertices);
        CHECK(vertices_of(fixture.mesh) == expected.vertices);
        CHECK(edge_count(fixture.mesh) == expected.edges);
        CHECK(fixture.mesh.faces.size() == expected.faces);
        CHECK(euler_of(fixture.mesh) == expected.euler);
        int border = 0;
        for (const auto& [edge, faces] : edges_of(fixture.mesh))
            border += faces == 1;
        CHECK(border == expected.border);
        CHECK(kinds_of(fixture.mesh) == expected.defects);
    }
}

TEST_CASE("with_table has the fixtures that have one, in the header's order") {
    const std::vector<Fixture> all = zoo::with_table();
    REQUIRE(all.size() == with_tables.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        CHECK(all[k].name == with_tables[k].name);
        CHECK_FALSE(all[k].he.empty());
    }
}

TEST_CASE("the slide's table has the lecture's rows, not the builder's") {
    const HalfEdgeTable he = zoo::slide().he;
    REQUIRE(he.size() == 16);
    CHECK(he[12].opp == 6);
    CHECK(he[7].fi == -1);
    int side_by_side = 0;
    for (int i = 0; i < 16; ++i) side_by_side += he[i].opp == (i ^ 1);
    CHECK(side_by_side == 2);
    std::vector<int> border;
    for (int i = 0; border.size() < 6; i = he[i].next)
        border.push_back(he[i].vi);
    CHECK(border == std::vector<int>{2, 0, 1, 4, 5, 3});
}

TEST_CASE("the bow-tie's two linkings differ at its middle and only there") {
    const HalfEdgeTable crossed = zoo::bow_tie_crossed().he;
    const HalfEdgeTable separate = zoo::bow_tie_separate().he;
    CHECK(zoo::bow_tie_crossed().mesh == zoo::bow_tie_separate().mesh);
    CHECK(star(crossed, 0) == std::vector<int>{1, 2, 3, 4});
    CHECK(star(crossed, 3) == std::vector<int>{1, 2, 3, 4});
    CHECK(star(separate, 0) == std::vector<int>{1, 2});
    CHECK(star(separate, 3) == std::vector<int>{3, 4});
    for (int i = 0; i < 12; ++i)
        CHECK((crossed[i] == separate[i]) == (i != 6 && i != 9));
}

TEST_CASE("the loose edge hangs from vertex 4, the walk passes both sides") {
    const HalfEdgeTable he = zoo::dangling().he;
    CHECK(star(he, 17) == std::vector<int>{4});
    CHECK(star(he, 16) == std::vector<int>{1, 5, 6});
    const HalfEdgeTable slide = zoo::slide().he;
    for (int i = 0; i < 16; ++i) CHECK((he[i] == slide[i]) == (i != 6));
}

TEST_CASE("flat fixtures run counter-clockwise, closed ones outwards") {
    for (const Fixture& fixture : zoo::with_table()) {
        CAPTURE(fixture.name);
        if (fixture.name == "pillow" || fixture.name == "tetra") continue;
        if (is_flat(fixture.mesh))
            for (int f = 0; f < fixture.mesh.faces.size(); ++f)
                CHECK(signed_area(fixture.mesh, f) > 0);
        else
            CHECK(six_volumes(fixture.mesh) > 0);
    }
    CHECK(six_volumes(zoo::tetra().mesh) == -16);
    CHECK(six_volumes(zoo::cube().mesh) == 6);
}

TEST_CASE("no two vertices of a fixture stand at one place") {
    std::vector<Fixture> all = zoo::with_table();
    for (const ExpectedWithout& expected : without_tables)
        all.push_back(expected.make());
    for (const Fixture& fixture : all) {
        const auto& p = fixture.mesh.positions;
        for (std::size_t a = 0; a < p.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                CHECK(length(p[a] - p[b]) > 0.1);
    }
}
