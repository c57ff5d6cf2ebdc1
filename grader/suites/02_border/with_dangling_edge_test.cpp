// Hidden suite of with_dangling_edge. The result comes from the submission and
// may be broken in any way: everything here stays within its rows.
#include "exercises/02_border/with_dangling_edge.h"

#include <algorithm>

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Rows = std::vector<HalfEdge>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

int tip(const Rows& rows, int i) {
    return rows[at(rows[at(i)].opp)].vi;
}

/// A vertex number that the mesh does not use; not always the next one.
int unused_vertex(const Fixture& fixture, int border) {
    return fixture.mesh.vertex_count() + border % 3;
}

/// What the contract asks for, when row `out` leads out and row `back` back.
Rows with_edge(Rows rows, int border, int new_vertex, int out, int back) {
    rows.resize(rows.size() + 2);
    rows[at(out)] = {tip(rows, border), -1, back, back};
    rows[at(back)] = {new_vertex, -1, rows[at(border)].next, out};
    rows[at(border)].next = out;
    return rows;
}

/// Asks for an edge, requires what the contract says, and returns the table.
HalfEdgeTable hung(const HalfEdgeTable& he, int border, int new_vertex) {
    const int first = he.size();
    const int second = first + 1;
    const HalfEdgeTable got = with_dangling_edge(he, border, new_vertex);
    const Rows& rows = got.rows();
    REQUIRE(got.size() == second + 1);
    const Rows wanted =
        rows[at(border)].next == second
            ? with_edge(he.rows(), border, new_vertex, second, first)
            : with_edge(he.rows(), border, new_vertex, first, second);
    const auto wrong = std::mismatch(rows.begin(), rows.end(), wanted.begin());
    if (wrong.first == rows.end()) return got;
    UNSCOPED_INFO("row " << wrong.first - rows.begin());
    REQUIRE(*wrong.first == *wrong.second);
    return got;
}

void check_every_corner(const Fixture& fixture) {
    const OnMesh on(fixture);
    for (const int border : oracle::border_rows(fixture.he))
        hung(fixture.he, border, unused_vertex(fixture, border));
}

/// The half-edges that step after step meets from i on, until it is back at i;
/// empty when it leaves the table or never comes back.
template <class Step>
std::vector<int> round_trip(const Rows& rows, int i, Step step) {
    std::vector<int> trip;
    int k = i;
    do {
        if (k < 0 || at(k) >= rows.size() || trip.size() > rows.size())
            return {};
        trip.push_back(k);
        k = step(k);
    } while (k != i);
    return trip;
}

/// The vertices that the border walk leaves, from half-edge `border` on; empty
/// when it comes to a half-edge with a face, or never comes back.
std::vector<int> walked(const HalfEdgeTable& he, int border) {
    const Rows& rows = he.rows();
    std::vector<int> trip =
        round_trip(rows, border, [&](int i) { return rows[at(i)].next; });
    for (int& i : trip) {
        if (rows[at(i)].fi != -1) return {};
        i = rows[at(i)].vi;
    }
    return trip;
}

/// How many edges the walk round the vertex meets that half-edge i leaves.
int degree(const HalfEdgeTable& he, int i) {
    const Rows& rows = he.rows();
    const auto trip = round_trip(rows, i, [&](int k) {
        const int opp = rows[at(k)].opp;
        return opp < 0 || at(opp) >= rows.size() ? -1 : rows[at(opp)].next;
    });
    return static_cast<int>(trip.size());
}

std::vector<Fixture> open_meshes() {
    return {zoo::slide(),    zoo::annulus(), hidden::keyhole(),
            zoo::dangling(), hidden::gaps(), renumbered(zoo::slide())};
}

}  // namespace

TEST_CASE("the old rows stay as they were, all but one next", "[points:1]") {
    hint("Which field of which old half-edge must change, and no other?");
    for (const Fixture& fixture : open_meshes()) {
        const OnMesh on(fixture);
        const Rows& before = fixture.he.rows();
        for (const int border : oracle::border_rows(fixture.he)) {
            const HalfEdgeTable got = with_dangling_edge(
                fixture.he, border, unused_vertex(fixture, border));
            REQUIRE(got.size() == fixture.he.size() + 2);
            CHECK(got.rows()[at(border)].next >= fixture.he.size());
            for (int i = 0; i < fixture.he.size(); ++i) {
                INFO("row " << i);
                HalfEdge row = got.rows()[at(i)];
                if (i == border) row.next = before[at(i)].next;
                CHECK(row == before[at(i)]);
            }
        }
    }
}

TEST_CASE("the border walk goes out to the new vertex and back", "[points:1]") {
    hint("After `border`, which half-edges come, and where do they lead?");
    for (const Fixture& fixture : open_meshes()) {
        const OnMesh on(fixture);
        for (const int border : oracle::border_rows(fixture.he)) {
            const int new_vertex = unused_vertex(fixture, border);
            std::vector<int> expected = walked(fixture.he, border);
            expected.insert(expected.begin() + 1,
                            {tip(fixture.he.rows(), border), new_vertex});
            CHECK(walked(with_dangling_edge(fixture.he, border, new_vertex),
                         border) == expected);
        }
    }
}

TEST_CASE("the tip gets one edge more, the new vertex has one", "[points:1]") {
    hint("At which end of `border` is the tip, and who leaves the new vertex?");
    for (const Fixture& fixture : open_meshes()) {
        const OnMesh on(fixture);
        for (const int border : oracle::border_rows(fixture.he)) {
            const int new_vertex = unused_vertex(fixture, border);
            const int at_tip = fixture.he.rows()[at(border)].next;
            const HalfEdgeTable got =
                with_dangling_edge(fixture.he, border, new_vertex);
            REQUIRE(got.size() == fixture.he.size() + 2);
            const int last = got.size() - 1;
            const int back =
                got.rows()[at(last)].vi == new_vertex ? last : last - 1;
            CHECK(got.rows()[at(back)].vi == new_vertex);
            CHECK(degree(got, back) == 1);
            CHECK(degree(got, at_tip) == degree(fixture.he, at_tip) + 1);
        }
    }
}

TEST_CASE("at each border corner of every mesh", "[points:1]") {
    hint("Is every field of the two new half-edges right, at every corner?");
    for (const Fixture& fixture : hidden::made_by_hand())
        check_every_corner(fixture);
    const Fixture gaps = hidden::gaps();
    const OnMesh on(gaps);
    for (const int unused : {0, 2, 16, 100})
        hung(gaps.he, oracle::border_rows(gaps.he).front(), unused);
}

TEST_CASE("numbers of half-edges and vertices mean nothing", "[points:1]") {
    hint("Which numbers do you work out that the table could tell you?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_every_corner(fixture);
    on_generated_meshes(hidden::generated_borders(), check_every_corner);
}

TEST_CASE("edges that hang on a new edge", "[points:1]") {
    hint("A loose edge is a piece of border. Can the next one hang on it?");
    for (const Fixture& fixture : open_meshes()) {
        const OnMesh on(fixture);
        const int border = oracle::border_rows(fixture.he).back();
        const int new_vertex = unused_vertex(fixture, border);
        const HalfEdgeTable one = hung(fixture.he, border, new_vertex);
        const int out = one.rows()[at(border)].next;
        const int back = one.rows()[at(out)].next;
        hung(one, out, new_vertex + 1);
        hung(one, back, new_vertex + 1);
        hung(one, border, new_vertex + 1);
    }
}

TEST_CASE("what does not lie on a border is refused", "[points:1]") {
    hint("Which numbers are no half-edge, and which half-edges have a face?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::tetra(), zoo::annulus(), zoo::dangling()}) {
        const OnMesh on(fixture);
        const int new_vertex = fixture.mesh.vertex_count();
        const int size = fixture.he.size();
        for (const int none : {-1, -2, size, size + 1, 1 << 30}) {
            CHECK_THROWS_AS(with_dangling_edge(fixture.he, none, new_vertex),
                            std::invalid_argument);
        }
        for (int i = 0; i < size; ++i) {
            if (fixture.he.rows()[at(i)].fi != -1)
                CHECK_THROWS_AS(with_dangling_edge(fixture.he, i, new_vertex),
                                std::invalid_argument);
        }
    }
    CHECK_THROWS_AS(with_dangling_edge(HalfEdgeTable(), 0, 0),
                    std::invalid_argument);
}
