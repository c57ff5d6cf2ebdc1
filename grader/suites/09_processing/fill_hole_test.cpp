// Hidden suite of fill_hole. Faces and borders are compared with those that the
// contract asks for, as loops of vertices.
#include "exercises/09_processing/fill_hole.h"

#include <algorithm>
#include <set>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/editing.h"
#include "grader/suites/meshes.h"

using namespace course;
using editing::Content;
using editing::Loop;

namespace {

std::vector<int> border_rows(const HalfEdgeTable& he) {
    std::vector<int> rows;
    for (int i = 0; i < he.size(); ++i)
        if (he.rows()[std::size_t(i)].fi == -1) rows.push_back(i);
    return rows;
}

/// The vertices of the loop of border half-edge i.
Loop loop_of(const HalfEdgeTable& he, int i) {
    Loop loop;
    int k = i;
    do {
        loop.push_back(he.rows()[std::size_t(k)].vi);
        k = he.rows()[std::size_t(k)].next;
    } while (k != i);
    return loop;
}

bool can_be_filled(const Loop& loop) {
    return loop.size() >= 3 &&
           std::set<int>(loop.begin(), loop.end()).size() == loop.size();
}

/// A vertex number that is not in use; not always the next one.
int free_vertex(const HalfEdgeTable& he, int salt) {
    std::set<int> used;
    for (const HalfEdge& half_edge : he.rows()) used.insert(half_edge.vi);
    int v = salt % 5 == 0 ? 0 : *used.rbegin() + salt % 4;
    while (used.contains(v)) ++v;
    return v;
}

HalfEdgeTable filled(const HalfEdgeTable& he, int border, int m) {
    INFO("half-edge " << border << "; new vertex " << m);
    Content expected = editing::content_of(he);
    const Loop loop = loop_of(he, border);
    const auto found =
        std::find(expected.borders.begin(), expected.borders.end(),
                  editing::from_smallest(loop));
    REQUIRE(found != expected.borders.end());
    expected.borders.erase(found);
    std::vector<Loop> triangles;
    for (std::size_t k = 0; k < loop.size(); ++k)
        triangles.push_back({loop[k], loop[(k + 1) % loop.size()], m});
    HalfEdgeTable got = fill_hole(he, border, m);
    REQUIRE_THAT(got, editing::Says(expected, triangles));
    return got;
}

/// Each border half-edge of each mesh: filled, or refused.
void check(const std::vector<Fixture>& fixtures) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        for (const int border : border_rows(fixture.he)) {
            const int m = free_vertex(fixture.he, border);
            if (can_be_filled(loop_of(fixture.he, border))) {
                filled(fixture.he, border, m);
                continue;
            }
            INFO("half-edge " << border);
            REQUIRE_THROWS_AS(fill_hole(fixture.he, border, m),
                              std::invalid_argument);
        }
    }
}

/// Vertices less edges plus faces.
int characteristic(const HalfEdgeTable& he) {
    std::set<int> vertices, faces;
    for (const HalfEdge& half_edge : he.rows()) {
        vertices.insert(half_edge.vi);
        if (half_edge.fi != -1) faces.insert(half_edge.fi);
    }
    return static_cast<int>(vertices.size()) - he.size() / 2 +
           static_cast<int>(faces.size());
}

}  // namespace

TEST_CASE("meshes with one hole", "[points:2]") {
    hint("Each triangle shares an edge with the next. The last one, too?");
    check({zoo::slide(), zoo::triangle(), zoo::lens(), zoo::fan6(),
           editing::one_quad(), editing::cut_square(), editing::open_tetra(),
           editing::ribbon(), hidden::twelve_gon(), hidden::spur(),
           hidden::keyhole()});
}

TEST_CASE("one hole of several, and the others stay", "[points:1]") {
    hint("Which half-edges on a border belong to this hole?");
    check({zoo::annulus(), editing::tube_of_three(), hidden::ring_of_two(),
           zoo::two_triangles(), zoo::bow_tie_separate(),
           hidden::open_then_closed(), hidden::closed_then_open()});
}

TEST_CASE("a loop that comes to a vertex twice is refused", "[points:1]") {
    hint("How many edges would join that vertex and the new one?");
    check({zoo::bow_tie_crossed(), zoo::dangling(), hidden::bridge(),
           hidden::thorn(), hidden::loose_pair(), hidden::loose_chain(),
           hidden::pinwheel_in_turn(), hidden::pinwheel_split(),
           hidden::pinwheel_across()});
}

TEST_CASE("the two sides of a loose edge are refused", "[points:1]") {
    hint("How many half-edges has this loop, and can they go round a hole?");
    check({hidden::loose_edge_after(), hidden::loose_edge_before()});
}

TEST_CASE("half-edges along a face, and numbers that will not do",
          "[points:1]") {
    hint("What must be known about `border`, and about new_vertex?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::tetra(), hidden::gaps()}) {
        const OnMesh on(fixture);
        const int size = fixture.he.size();
        for (const int none : {-1, -2, size, size + 1, 1 << 30})
            CHECK_THROWS_AS(fill_hole(fixture.he, none, 100),
                            std::invalid_argument);
        const std::vector<int> borders = border_rows(fixture.he);
        for (int i = 0; i < size; ++i)
            if (std::count(borders.begin(), borders.end(), i) == 0)
                CHECK_THROWS_AS(fill_hole(fixture.he, i, 100),
                                std::invalid_argument);
        for (const int border : borders) {
            CHECK_THROWS_AS(fill_hole(fixture.he, border, -1),
                            std::invalid_argument);
            for (const HalfEdge& half_edge : fixture.he.rows())
                CHECK_THROWS_AS(fill_hole(fixture.he, border, half_edge.vi),
                                std::invalid_argument);
        }
    }
    CHECK_THROWS_AS(fill_hole(HalfEdgeTable(), 0, 0), std::invalid_argument);
}

TEST_CASE("face numbers with gaps", "[points:1]") {
    hint("Is the number of the faces a number that no face has?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::annulus(), zoo::triangle(), hidden::gaps(),
          editing::ribbon(), hidden::ring_of_two()})
        check({editing::with_gaps_in_faces(fixture)});
}

TEST_CASE("numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which number do you work out that the table could tell you?");
    check(hidden::renumbered_copies());
}

TEST_CASE("generated meshes, hole after hole", "[points:1]") {
    hint("When all holes are closed: is any half-edge left without a face?");
    for (const Fixture& fixture : editing::generated_surfaces()) {
        check({fixture});
        const OnMesh on(fixture);
        HalfEdgeTable he = fixture.he;
        while (!border_rows(he).empty()) {
            const int before = characteristic(he);
            const int i = border_rows(he).back();
            he = filled(he, i, free_vertex(he, i));
            CHECK(characteristic(he) == before + 1);
        }
    }
}

TEST_CASE("a hole of 12 000 half-edges", "[points:1][once]") {
    hint("For each half-edge of the loop: do you walk all of it again?");
    const Fixture fixture = editing::made("long strip", grid(5999, 1));
    const OnMesh on(fixture);
    const int border = border_rows(fixture.he).front();
    const HalfEdgeTable got =
        fill_hole(fixture.he, border, fixture.mesh.vertex_count());
    CHECK(got.size() == fixture.he.size() + 24000);
    CHECK(editing::broken_rule(got) == "");
    CHECK(border_rows(got).empty());
}
