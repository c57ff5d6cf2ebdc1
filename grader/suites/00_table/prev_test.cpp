// Hidden suite of prev.
#include "exercises/00_table/prev.h"
#include "course/runner/suite.h"
#include "grader/suites/00_table/by_definition.h"
#include "grader/suites/for_each_half_edge.h"
#include "grader/suites/meshes.h"

using namespace course;
using oracle::row;

namespace {

/// The half-edge that runs along face f from its corner before `vertex`.
int side_before(const Fixture& fixture, int f, int vertex) {
    for (int j = 0; j < fixture.he.size(); ++j)
        if (row(fixture, j).fi == f && oracle::arrives_at(fixture, j) == vertex)
            return j;
    return -1;
}

void check_all(const Fixture& fixture) {
    const OnMesh on(fixture);
    const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
    const std::vector<int> before = oracle::previous(fixture.he);
    for (int i = 0; i < fixture.he.size(); ++i)
        REQUIRE(::prev(fixture.he, i) == before[static_cast<std::size_t>(i)]);
}

void check_border(const Fixture& fixture) {
    const OnMesh on(fixture);
    const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
    const std::vector<int> before = oracle::previous(fixture.he);
    for (const int i : oracle::border(fixture))
        CHECK(::prev(fixture.he, i) == before[static_cast<std::size_t>(i)]);
}

/// Reads that the contract allows: generous to a walk and to a turn.
std::int64_t allowance(std::int64_t loop, std::int64_t star) {
    return 4 * (loop + star) + 8;
}

}  // namespace

TEST_CASE("faces of every size, at each of their sides", "[points:2]") {
    hint("Which half-edge of the face has i as its next?");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i) {
            const HalfEdge& half_edge = row(fixture, i);
            if (half_edge.fi != -1)
                CHECK(::prev(fixture.he, i) ==
                      side_before(fixture, half_edge.fi, half_edge.vi));
        }
    }
}

TEST_CASE("border loops of every mesh, at each half-edge", "[points:1]") {
    hint("How long may a border loop be, and does your walk know when to end?");
    for (const Fixture& fixture : all_fixtures()) check_border(fixture);
}

TEST_CASE("a vertex that a loop passes more than once", "[points:1]") {
    hint(
        "Two half-edges of one loop may arrive at the vertex of i. Which of "
        "them goes on with i?");
    for (const Fixture& fixture :
         {zoo::bow_tie_crossed(), zoo::bow_tie_separate(), hidden::spur(),
          hidden::keyhole()}) {
        check_all(fixture);
        check_all(renumbered(fixture));
    }
}

TEST_CASE("an edge without any face, there and back", "[points:1]") {
    hint("How did the walk come to the half-edge that leaves a loose end?");
    check_border(zoo::dangling());
    check_border(renumbered(zoo::dangling(), 1));
    check_border(renumbered(zoo::dangling(), 2));
}

TEST_CASE("the half-edge before, on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    on_generated_meshes(generated_fixtures(), check_all);
}

TEST_CASE("the way back costs no more than one way round",
          "[points:1][large]") {
    hint(
        "Which half-edges can come before i? Must you look at all the others?");
    const LargeMesh& large = a_million_half_edges();
    const std::vector<int> before = oracle::previous(large.tile.he);
    const auto check = [&](const HalfEdgeTable& he, const InLargeMesh& at) {
        const int expected = before[static_cast<std::size_t>(at.i)];
        REQUIRE(::prev(he, at.row()) == at.mesh->half_edges(expected, at.copy));
    };
    std::vector<InLargeMesh> asked = some_of(large, many_calls);
    const auto has_face = [&](const InLargeMesh& at) {
        return row(large.tile, at.i).fi != -1;
    };
    const auto on_border =
        std::stable_partition(asked.begin(), asked.end(), has_face);
    const std::vector<InLargeMesh> border(on_border, asked.end());
    asked.erase(on_border, asked.end());
    hidden::for_each_asked(large, asked, allowance(4, 4), check);
    const auto length =
        static_cast<std::int64_t>(oracle::border(large.tile).size());
    hidden::for_each_asked(large, border, allowance(length, 4), check);
}
