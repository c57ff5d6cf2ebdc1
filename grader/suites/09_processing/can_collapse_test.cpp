// Hidden suite of can_collapse. What is expected is found by doing it, on loops
// of vertices, and looking at what has become of the mesh.
#include "exercises/09_processing/can_collapse.h"

#include "course/runner/suite.h"
#include "grader/suites/09_processing/editing.h"
#include "grader/suites/meshes.h"

using namespace course;
using hidden::half_edge;

namespace {

/// Asks for each half-edge of the mesh for which where(content, a, b) holds.
template <class Where>
void check_where(const Fixture& fixture, Where where) {
    const OnMesh on(fixture);
    const editing::Content content = editing::content_of(fixture.he);
    const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
    for (int i = 0; i < fixture.he.size(); ++i) {
        const auto [a, b] = editing::ends(fixture.he, i);
        const bool got = can_collapse(fixture.he, i);
        if (!where(content, a, b)) continue;
        INFO("half-edge " << i << ", from vertex " << a << " to " << b);
        REQUIRE(got == editing::may_be_pulled_together(content, a, b));
    }
}

void check_all(const std::vector<Fixture>& fixtures) {
    for (const Fixture& fixture : fixtures)
        check_where(fixture,
                    [](const editing::Content&, int, int) { return true; });
}

bool on_border(const editing::Content& content, int v) {
    for (const editing::Loop& border : content.borders)
        for (const int u : border)
            if (u == v) return true;
    return false;
}

bool both_inside(const editing::Content& content, int a, int b) {
    return !on_border(content, a) && !on_border(content, b);
}

bool at_border(const editing::Content& content, int a, int b) {
    return !both_inside(content, a, b);
}

/// Both half-edges of the edge a-b.
void check_edge(const Fixture& fixture, int a, int b, bool expected) {
    const OnMesh on(fixture);
    INFO("edge " << a << "-" << b);
    CHECK(can_collapse(fixture.he, half_edge(fixture, a, b)) == expected);
    CHECK(can_collapse(fixture.he, half_edge(fixture, b, a)) == expected);
}

void check_no_edge(const Fixture& fixture) {
    const OnMesh on(fixture);
    for (int i = 0; i < fixture.he.size(); ++i)
        REQUIRE_FALSE(can_collapse(fixture.he, i));
}

}  // namespace

TEST_CASE("edges away from the border", "[points:2]") {
    hint("Which vertices are neighbours of both ends, and may they be?");
    for (const Fixture& fixture : editing::surfaces())
        check_where(fixture, both_inside);
}

TEST_CASE("edges with an end on the border", "[points:1]") {
    hint("Which edges lead from border to border, through the inside?");
    for (const Fixture& fixture : editing::surfaces())
        check_where(fixture, at_border);
}

TEST_CASE("a neck of three edges is not tied off", "[points:1]") {
    hint("Walk round a neck of three. Is each third vertex on a triangle?");
    check_edge(editing::neck(), 6, 7, false);
    check_edge(editing::neck(), 8, 6, false);
    check_edge(editing::neck(), 15, 0, true);
    check_edge(editing::three_peaks(), 0, 1, false);
    check_edge(editing::three_peaks(), 0, 3, true);
    check_edge(editing::tube_of_three(), 0, 1, false);
    check_edge(editing::tube_of_three(), 3, 4, false);
    check_no_edge(zoo::torus7());
    check_no_edge(hidden::two_tori());
}

TEST_CASE("a strip and the hole of a ring stay open", "[points:1]") {
    hint("What becomes of two pieces of border that meet in one vertex?");
    check_edge(editing::cut_square(), 0, 2, false);
    check_edge(editing::cut_square(), 0, 1, true);
    check_edge(editing::ribbon(), 1, 2, false);
    check_edge(editing::ribbon(), 2, 3, false);
    check_edge(editing::ribbon(), 2, 4, true);
    check_edge(editing::tube_of_three(), 0, 3, false);
    check_edge(zoo::annulus(), 0, 3, false);
    check_edge(zoo::annulus(), 0, 1, false);
}

TEST_CASE("what is left must be more than a pillow or a loose edge",
          "[points:1]") {
    hint("How many edges has the one vertex, for each kind of its ends?");
    check_no_edge(zoo::tetra());
    check_no_edge(zoo::triangle());
    check_no_edge(zoo::two_triangles());
    check_edge(editing::one_quad(), 0, 1, true);
    check_edge(editing::cut_square(), 2, 3, true);
    check_edge(editing::octahedron(), 0, 4, true);
}

TEST_CASE("faces with more than three sides", "[points:1]") {
    hint(
        "Which faces have a corner at each end without running along the "
        "edge?");
    check_edge(editing::hexagon_lid(), 0, 3, false);
    check_edge(editing::hexagon_lid(), 0, 1, true);
    check_edge(editing::ear(), 0, 4, true);
    check_edge(hidden::prism(), 0, 6, true);
    check_edge(hidden::twelve_gon(), 3, 4, true);
    check_edge(zoo::house(), 0, 1, true);
}

TEST_CASE("numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which numbers do you take for granted that the table could tell?");
    check_all(editing::renumbered_surfaces());
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Try all four rules, in turn: which one answers otherwise?");
    check_all(editing::generated_surfaces());
}

TEST_CASE("numbers that are no half-edge", "[points:1]") {
    hint("Which question must come before the table is read at i?");
    for (const Fixture& fixture : {zoo::slide(), zoo::cube()}) {
        const OnMesh on(fixture);
        for (const int none : {-1, -2, fixture.he.size(), 1 << 30})
            CHECK_FALSE(can_collapse(fixture.he, none));
        CHECK(can_collapse(fixture.he, half_edge(fixture, 0, 1)));
    }
    CHECK_FALSE(can_collapse(HalfEdgeTable(), 0));
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How much of the table lies round the two ends of one edge?");
    const LargeMesh& large = a_million_half_edges();
    std::vector<int> rows;
    const std::vector<InLargeMesh> asked = some_of(large, many_calls);
    for (const InLargeMesh& at : asked) rows.push_back(at.row());
    const AskAhead ahead(large.he, rows);
    for (const InLargeMesh& at : asked) {
        const ReadBudget budget(large.he, 1000);
        // All of the grid may go but for edges from border to border inside,
        // which a grid of 25 x 25 has not.
        REQUIRE(can_collapse(large.he, at.row()));
    }
}
