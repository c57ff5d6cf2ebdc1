// Hidden suite of collapse. What comes back is compared with the collapse of
// loops of vertices; it is read only once it is known to be valid.
#include "exercises/09_processing/collapse.h"

#include <set>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/editing.h"
#include "grader/suites/meshes.h"

using namespace course;
using editing::Content;

namespace {

/// Collapses, requires the right table, and returns it.
HalfEdgeTable collapsed(const HalfEdgeTable& he, const Content& content,
                        int i) {
    const auto [a, b] = editing::ends(he, i);
    INFO("half-edge " << i << ", from vertex " << a << " to " << b);
    HalfEdgeTable got = collapse(he, i);
    REQUIRE_THAT(got, editing::Says(editing::pulled_together(content, a, b)));
    return got;
}

enum class Along { triangles, border, larger };

/// What lies along the edge of half-edge i.
Along along(const HalfEdgeTable& he, const Content& content, int i) {
    const auto at = [&](int k) { return he.rows()[std::size_t(k)]; };
    bool larger = false;
    for (const int f : {at(i).fi, at(at(i).opp).fi}) {
        if (f == -1) return Along::border;
        larger = larger || content.faces.at(f).size() > 3;
    }
    return larger ? Along::larger : Along::triangles;
}

void check(const std::vector<Fixture>& fixtures, std::set<Along> kinds) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const Content content = editing::content_of(fixture.he);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const auto [a, b] = editing::ends(fixture.he, i);
            if (kinds.contains(along(fixture.he, content, i)) &&
                editing::may_be_pulled_together(content, a, b))
                collapsed(fixture.he, content, i);
        }
    }
}

void check_all(const std::vector<Fixture>& fixtures) {
    check(fixtures, {Along::triangles, Along::border, Along::larger});
}

int vertices(const HalfEdgeTable& he) {
    std::set<int> used;
    for (const HalfEdge& row : he.rows()) used.insert(row.vi);
    return static_cast<int>(used.size());
}

/// A half-edge that may be collapsed, the `k`-th of them in a circle; -1 when
/// there is none.
int some_half_edge(const HalfEdgeTable& he, const Content& content, int k) {
    for (int n = 0; n < he.size(); ++n) {
        const int i = (k + n) % he.size();
        const auto [a, b] = editing::ends(he, i);
        if (editing::may_be_pulled_together(content, a, b)) return i;
    }
    return -1;
}

/// Collapses one edge after the other, until no edge may go.
HalfEdgeTable collapsed_to_the_end(const Fixture& fixture, int salt) {
    const OnMesh on(fixture);
    HalfEdgeTable he = fixture.he;
    for (int step = salt;; step += 37) {
        const Content content = editing::content_of(he);
        const int i = some_half_edge(he, content, step);
        if (i == -1) return he;
        he = collapsed(he, content, i);
    }
}

}  // namespace

TEST_CASE("between two triangles", "[points:2]") {
    hint("Two triangles go. Which half-edges that are left get a new opp?");
    check(editing::surfaces(), {Along::triangles});
}

TEST_CASE("on the border", "[points:1]") {
    hint("Where does the border go when one of its half-edges is left out?");
    check(editing::surfaces(), {Along::border});
}

TEST_CASE("along a face with more than three sides", "[points:1]") {
    hint("Which half-edge of a larger face must get another next?");
    check(editing::surfaces(), {Along::larger});
}

TEST_CASE("the start goes and the tip stays", "[points:1]") {
    hint("Which end of half-edge i is left, and which rows name the other?");
    for (const Fixture& fixture : {editing::octahedron(), hidden::bipyramid(),
                                   editing::ribbon(), hidden::prism()}) {
        const OnMesh on(fixture);
        const Content content = editing::content_of(fixture.he);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const auto [a, b] = editing::ends(fixture.he, i);
            if (!editing::may_be_pulled_together(content, a, b)) continue;
            std::set<int> named;
            const HalfEdgeTable got = collapse(fixture.he, i);
            for (const HalfEdge& row : got.rows()) named.insert(row.vi);
            CHECK_FALSE(named.contains(a));
            CHECK(named.contains(b));
            CHECK(vertices(got) == vertices(fixture.he) - 1);
        }
    }
}

TEST_CASE("an edge that may not be collapsed is refused", "[points:1]") {
    hint("What must be asked before anything is changed?");
    for (const Fixture& fixture : editing::surfaces()) {
        const OnMesh on(fixture);
        const Content content = editing::content_of(fixture.he);
        const int size = fixture.he.size();
        for (int i = 0; i < size; ++i) {
            const auto [a, b] = editing::ends(fixture.he, i);
            if (editing::may_be_pulled_together(content, a, b)) continue;
            INFO("half-edge " << i << ", from vertex " << a << " to " << b);
            REQUIRE_THROWS_AS(collapse(fixture.he, i), std::invalid_argument);
        }
        for (const int none : {-1, size, size + 7})
            REQUIRE_THROWS_AS(collapse(fixture.he, none),
                              std::invalid_argument);
    }
}

TEST_CASE("numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which number do you work out that the table could tell you?");
    check_all(editing::renumbered_surfaces());
}

TEST_CASE("generated meshes", "[points:1]") {
    hint(
        "Does each old next and opp have its new number, and all rows theirs?");
    check_all(editing::generated_surfaces());
}

TEST_CASE("again and again, down to the tetrahedron", "[points:1]") {
    hint("Is what you return as good a table as the one that you were given?");
    const Fixture sphere = editing::made("sphere", icosphere(1));
    int salt = 0;
    for (const Fixture& fixture :
         {editing::octahedron(), hidden::bipyramid(), editing::neck(), sphere,
          renumbered(sphere, 1), renumbered(sphere, 2)}) {
        const HalfEdgeTable last = collapsed_to_the_end(fixture, ++salt);
        CHECK(last.size() == 12);
        CHECK(vertices(last) == 4);
    }
    for (const Fixture& fixture :
         {editing::ribbon(), hidden::gaps(), zoo::fan6()}) {
        CHECK(collapsed_to_the_end(fixture, ++salt).size() == 6);
    }
    for (const Fixture& fixture : editing::generated_surfaces())
        collapsed_to_the_end(fixture, ++salt);
}

TEST_CASE("a mesh of 26 000 half-edges", "[points:1]") {
    hint("Is there a step that you do for each row, and that reads each row?");
    const Fixture fixture = editing::made("large grid", grid(80, 80));
    const OnMesh on(fixture);
    const HalfEdgeTable got = collapse(fixture.he, 1000);
    REQUIRE(got.size() == fixture.he.size() - 2);
    CHECK(editing::broken_rule(got) == "");
}
