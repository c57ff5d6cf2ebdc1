// Hidden suite of split_edge. Faces and borders are compared with those that
// the contract asks for, as loops of vertices.
#include "exercises/09_processing/split_edge.h"

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

const HalfEdge& row(const HalfEdgeTable& he, int i) {
    return he.rows()[std::size_t(i)];
}

/// What the contract asks for: faces with new numbers are apart.
struct Expected {
    bool refused = false;
    Content content;
    std::vector<Loop> new_faces;
};

/// Puts m between a and b wherever a loop goes from a to b.
void put_between(Loop& loop, int a, int b, int m) {
    for (std::size_t k = 0; k < loop.size(); ++k)
        if (loop[k] == a && loop[(k + 1) % loop.size()] == b)
            loop.insert(loop.begin() + std::ptrdiff_t(k) + 1, m), ++k;
}

Expected expected_of(const HalfEdgeTable& he, int i, int m) {
    const auto [a, b] = editing::ends(he, i);
    Expected after{.content = editing::content_of(he), .new_faces = {}};
    std::vector<int> thirds;
    for (const int f : {row(he, i).fi, row(he, row(he, i).opp).fi}) {
        if (f == -1) continue;
        Loop& face = after.content.faces[f];
        if (face.size() != 3)
            return {.refused = true, .content = {}, .new_faces = {}};
        Loop at_b = face;
        for (const int v : face)
            if (v != a && v != b) thirds.push_back(v);
        std::replace(face.begin(), face.end(), b, m);
        std::replace(at_b.begin(), at_b.end(), a, m);
        after.new_faces.push_back(at_b);
    }
    after.refused = thirds.size() == 2 && thirds[0] == thirds[1];
    for (Loop& border : after.content.borders) {
        put_between(border, a, b, m);
        put_between(border, b, a, m);
    }
    after.content = editing::in_order(std::move(after.content));
    return after;
}

/// A vertex number that is not in use; not always the next one.
int free_vertex(const HalfEdgeTable& he, int salt) {
    std::set<int> used;
    for (const HalfEdge& half_edge : he.rows()) used.insert(half_edge.vi);
    int v = salt % 5 == 0 ? 0 : *used.rbegin() + salt % 4;
    while (used.contains(v)) ++v;
    return v;
}

HalfEdgeTable split(const HalfEdgeTable& he, int i, const Expected& expected,
                    int m) {
    const auto [a, b] = editing::ends(he, i);
    INFO("half-edge " << i << ", from vertex " << a << " to " << b
                      << "; new vertex " << m);
    HalfEdgeTable got = split_edge(he, i, m);
    REQUIRE_THAT(got, editing::Says(expected.content, expected.new_faces));
    return got;
}

void check(const std::vector<Fixture>& fixtures, std::set<int> sides) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const int m = free_vertex(fixture.he, i);
            const Expected expected = expected_of(fixture.he, i, m);
            if (expected.refused) continue;
            const int faces = static_cast<int>(expected.new_faces.size());
            if (sides.contains(faces)) split(fixture.he, i, expected, m);
        }
    }
}

void check_refused(const std::vector<Fixture>& fixtures) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const int m = fixture.mesh.vertex_count();
            if (!expected_of(fixture.he, i, m).refused) continue;
            INFO("half-edge " << i);
            REQUIRE_THROWS_AS(split_edge(fixture.he, i, m),
                              std::invalid_argument);
        }
    }
}

std::vector<Fixture> meshes() {
    std::vector<Fixture> all = editing::surfaces();
    for (const Fixture& fixture :
         {zoo::hourglass(), zoo::bow_tie_crossed(), zoo::bow_tie_separate(),
          hidden::pinwheel_in_turn(), hidden::pinwheel_split()})
        all.push_back(fixture);
    return all;
}

}  // namespace

TEST_CASE("between two triangles", "[points:2]") {
    hint(
        "Two triangles are cut. Which half is at the start of i, on each "
        "side?");
    check(meshes(), {2});
}

TEST_CASE("on the border", "[points:1]") {
    hint("The border passes through m. Is it told, on the way there and on?");
    check(meshes(), {1});
}

TEST_CASE("loose edges", "[points:1]") {
    hint("What does the half-edge lead to that turns round at a loose end?");
    check({zoo::dangling(), hidden::loose_edge_after(),
           hidden::loose_edge_before(), hidden::loose_chain(),
           hidden::loose_pair(), hidden::thorn(), hidden::bridge()},
          {0, 1, 2});
}

TEST_CASE("a face with more sides is refused, and so is a pillow",
          "[points:1]") {
    hint("How many sides has each face there? And which are the new edges?");
    check_refused({zoo::slide(), zoo::cube(), zoo::house(), zoo::lens(),
                   hidden::prism(), editing::hexagon_lid(), zoo::pillow(),
                   editing::one_quad(), hidden::twelve_gon()});
}

TEST_CASE("numbers of half-edges and of new vertices that will not do",
          "[points:1]") {
    hint("What must be known about i, and about new_vertex?");
    for (const Fixture& fixture : {zoo::tetra(), hidden::gaps()}) {
        const OnMesh on(fixture);
        const int size = fixture.he.size();
        for (const int none : {-1, -2, size, size + 1, 1 << 30})
            CHECK_THROWS_AS(split_edge(fixture.he, none, 100),
                            std::invalid_argument);
        CHECK_THROWS_AS(split_edge(fixture.he, 0, -1), std::invalid_argument);
        for (const HalfEdge& half_edge : fixture.he.rows())
            CHECK_THROWS_AS(split_edge(fixture.he, 0, half_edge.vi),
                            std::invalid_argument);
    }
    CHECK_THROWS_AS(split_edge(HalfEdgeTable(), 0, 0), std::invalid_argument);
}

TEST_CASE("face numbers with gaps", "[points:1]") {
    hint("Is the number of the faces a number that no face has?");
    for (const Fixture& fixture : {zoo::slide(), zoo::tetra(), zoo::fan6(),
                                   editing::octahedron(), editing::ribbon()})
        check({editing::with_gaps_in_faces(fixture)}, {1, 2});
}

TEST_CASE("numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which number do you work out that the table could tell you?");
    check(editing::renumbered_surfaces(), {1, 2});
    check_refused(editing::renumbered_surfaces());
}

TEST_CASE("generated meshes, and split after split", "[points:1]") {
    hint("Is what you return as good a table as the one that you were given?");
    for (const Fixture& fixture :
         editing::of_triangles(editing::generated_surfaces())) {
        check({fixture}, {1, 2});
        const OnMesh on(fixture);
        HalfEdgeTable he = fixture.he;
        for (int step = 0; step < 20; ++step) {
            const int i = (31 * step + 5) % he.size();
            const int m = free_vertex(he, step);
            he = split(he, i, expected_of(he, i, m), m);
        }
    }
    check_refused(editing::generated_surfaces());
}

TEST_CASE("a mesh of 38 000 half-edges", "[points:1]") {
    hint("Is there a step that you do for each row, and that reads each row?");
    const Fixture fixture =
        editing::made("large grid", grid(80, 80, Cells::triangles));
    const OnMesh on(fixture);
    const int m = fixture.mesh.vertex_count();
    const HalfEdgeTable got = split_edge(fixture.he, 1000, m);
    CHECK(got.size() == fixture.he.size() + 6);
    CHECK(editing::broken_rule(got) == "");
}
