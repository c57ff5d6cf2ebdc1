// Hidden suite of flip_edge. Faces and borders are compared with those that the
// contract asks for, as loops of vertices, and the rows with those before.
#include "exercises/09_processing/flip_edge.h"

#include <algorithm>
#include <optional>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/editing.h"
#include "grader/suites/meshes.h"

using namespace course;
using editing::Content;
using editing::Loop;
using hidden::half_edge;

namespace {

const HalfEdge& row(const HalfEdgeTable& he, int i) {
    return he.rows()[std::size_t(i)];
}

/// The corner of face f that is neither a nor b; none when it is no triangle.
std::optional<int> third(const Content& content, int f, int a, int b) {
    if (f == -1 || content.faces.at(f).size() != 3) return std::nullopt;
    for (const int v : content.faces.at(f))
        if (v != a && v != b) return v;
    return std::nullopt;
}

bool are_joined(const Content& content, int c, int d) {
    for (const auto& [f, loop] : content.faces)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const int u = loop[k], v = loop[(k + 1) % loop.size()];
            if ((u == c && v == d) || (u == d && v == c)) return true;
        }
    return false;
}

/// Faces and borders after the flip; none when it is to be refused.
std::optional<Content> after_flip(const HalfEdgeTable& he, Content content,
                                  int i) {
    const auto [a, b] = editing::ends(he, i);
    const int left = row(he, i).fi, right = row(he, row(he, i).opp).fi;
    const auto c = third(content, left, a, b), d = third(content, right, a, b);
    if (!c || !d || *c == *d || are_joined(content, *c, *d))
        return std::nullopt;
    content.faces[left] = {*d, *c, a};
    content.faces[right] = {*c, *d, b};
    return editing::in_order(std::move(content));
}

/// No row but those of the edge has another vertex or another opposite.
std::string changed_row(const HalfEdgeTable& got, const HalfEdgeTable& he,
                        int i) {
    if (got.size() != he.size()) return "the table has another size";
    for (int k = 0; k < he.size(); ++k) {
        const bool same_start = row(got, k).vi == row(he, k).vi;
        if (row(got, k).opp != row(he, k).opp ||
            (!same_start && k != i && k != row(he, i).opp))
            return "row " + std::to_string(k) + " has another vi or opp";
    }
    return "";
}

HalfEdgeTable flipped(const HalfEdgeTable& he, const Content& expected, int i) {
    const auto [a, b] = editing::ends(he, i);
    INFO("half-edge " << i << ", from vertex " << a << " to " << b);
    HalfEdgeTable got = flip_edge(he, i);
    REQUIRE(changed_row(got, he, i) == "");
    REQUIRE_THAT(got, editing::Says(expected));
    const Loop face = expected.faces.at(row(he, i).fi);
    REQUIRE(std::find(face.begin(), face.end(), b) == face.end());
    REQUIRE(editing::ends(got, i).first != a);
    return got;
}

void check(const std::vector<Fixture>& fixtures) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const Content content = editing::content_of(fixture.he);
        for (int i = 0; i < fixture.he.size(); ++i)
            if (const auto after = after_flip(fixture.he, content, i))
                flipped(fixture.he, *after, i);
    }
}

void check_refused(const Fixture& fixture) {
    const OnMesh on(fixture);
    const Content content = editing::content_of(fixture.he);
    for (int i = 0; i < fixture.he.size(); ++i) {
        if (after_flip(fixture.he, content, i)) continue;
        INFO("half-edge " << i);
        REQUIRE_THROWS_AS(flip_edge(fixture.he, i), std::invalid_argument);
    }
}

std::vector<Fixture> spheres() {
    const Fixture sphere = editing::made("sphere", icosphere(1));
    return {editing::octahedron(), hidden::bipyramid(), editing::neck(), sphere,
            renumbered(sphere, 3)};
}

}  // namespace

TEST_CASE("edges of closed meshes", "[points:2]") {
    hint("Six half-edges lie in the two triangles. Is each next right?");
    check(spheres());
    for (const Fixture& fixture :
         {zoo::house(), zoo::torus7(), hidden::two_tori()})
        check({fixture});
}

TEST_CASE("edges of open meshes", "[points:1]") {
    hint("The outer sides may lie on the border. Does that matter at all?");
    check(editing::surfaces());
}

TEST_CASE("i runs from d to c, along its old face", "[points:1]") {
    hint("Which way does the half-edge turn, and on which side is its face?");
    for (const Fixture& fixture : spheres()) {
        const OnMesh on(fixture);
        const Content content = editing::content_of(fixture.he);
        for (int i = 0; i < fixture.he.size(); ++i) {
            if (!after_flip(fixture.he, content, i)) continue;
            const auto [a, b] = editing::ends(fixture.he, i);
            const int left = row(fixture.he, i).fi;
            const int j = row(fixture.he, i).opp;
            const HalfEdgeTable got = flip_edge(fixture.he, i);
            REQUIRE(changed_row(got, fixture.he, i) == "");
            CHECK(row(got, i).fi == left);
            CHECK(row(got, i).vi ==
                  third(content, row(fixture.he, j).fi, a, b));
            CHECK(row(got, j).vi == third(content, left, a, b));
        }
    }
}

TEST_CASE("borders and larger faces are refused", "[points:1]") {
    hint("How many sides have the faces along the edge, and are there two?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::cube(), zoo::house(), zoo::triangle(),
          editing::ribbon(), editing::hexagon_lid(), zoo::lens(),
          editing::one_quad(), hidden::prism()})
        check_refused(fixture);
}

TEST_CASE("an edge that is there already is not made twice", "[points:1]") {
    hint("Walk round one of the two corners. Do you meet the other one?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::pillow(), zoo::torus7(), editing::three_peaks(),
          editing::tube_of_three(), editing::octahedron(),
          editing::open_tetra()})
        check_refused(fixture);
    const Fixture tetra = zoo::tetra();
    for (int i = 0; i < 12; ++i)
        CHECK_THROWS_AS(flip_edge(tetra.he, i), std::invalid_argument);
}

TEST_CASE("numbers that are no half-edge are refused", "[points:1]") {
    hint("Which question comes before the table is read at i?");
    const Fixture fixture = editing::octahedron();
    const OnMesh on(fixture);
    for (const int none : {-1, -2, 24, 25, 1 << 30})
        CHECK_THROWS_AS(flip_edge(fixture.he, none), std::invalid_argument);
    CHECK_THROWS_AS(flip_edge(HalfEdgeTable(), 0), std::invalid_argument);
}

TEST_CASE("numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which number do you work out that the table could tell you?");
    for (const Fixture& fixture : editing::renumbered_surfaces()) {
        check({fixture});
        check_refused(fixture);
    }
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Try the four reasons to refuse in turn: is one too strict, or lax?");
    for (const Fixture& fixture : editing::generated_surfaces()) {
        check({fixture});
        check_refused(fixture);
    }
}

TEST_CASE("flip after flip", "[points:1]") {
    hint("Is what you return as good a table as the one that you were given?");
    for (const Fixture& fixture : spheres()) {
        const OnMesh on(fixture);
        HalfEdgeTable he = fixture.he;
        for (int step = 0; step < 60; ++step) {
            const int i = (7 * step + 3) % he.size();
            const auto after = after_flip(he, editing::content_of(he), i);
            if (after) he = flipped(he, *after, i);
        }
        const auto around = after_flip(he, editing::content_of(he), 0);
        if (!around) continue;
        HalfEdgeTable turned = he;
        for (int k = 0; k < 4; ++k) {
            turned = flip_edge(turned, 0);
            REQUIRE(editing::broken_rule(turned) == "");
        }
        CHECK(turned == he);
    }
}
