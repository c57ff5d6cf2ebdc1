#include "grader/suites/02_border/walk_checks.h"

#include <algorithm>

#include "course/runner/suite.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/for_each_half_edge.h"

namespace course::walk_checks {

using oracle::Border;

namespace {

const HalfEdge& row(const Fixture& fixture, int i) {
    return fixture.he.rows()[static_cast<std::size_t>(i)];
}

}  // namespace

void from_the_border(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    const AskAhead ahead(fixture.he, oracle::sample(fixture.he));
    for (const int i : oracle::sample(fixture.he))
        if (border.has(i))
            REQUIRE_THAT(boundary_walk(fixture.he, i),
                         IsRotationOf(border.walk(i)));
}

void from_beside_the_border(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    const AskAhead ahead(fixture.he, oracle::sample(fixture.he));
    for (const int i : oracle::sample(fixture.he))
        if (!border.has(i) && border.faces_at(i) == 1)
            REQUIRE_THAT(boundary_walk(fixture.he, i),
                         IsRotationOf(border.walk(i)));
}

void from_within(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    const AskAhead ahead(fixture.he, oracle::sample(fixture.he));
    for (const int i : oracle::sample(fixture.he))
        if (border.faces_at(i) == 2)
            REQUIRE(boundary_walk(fixture.he, i) == std::vector<int>{});
}

void from_everywhere(Walk boundary_walk, const Fixture& fixture) {
    from_the_border(boundary_walk, fixture);
    from_beside_the_border(boundary_walk, fixture);
    from_within(boundary_walk, fixture);
}

void cost(Walk boundary_walk) {
    const LargeMesh& large = a_million_half_edges();
    const auto has_face = [&](int i) { return row(large.tile, i).fi != -1; };
    std::vector<InLargeMesh> within = some_of(large, many_calls);
    std::erase_if(within, [&](const InLargeMesh& at) {
        return !has_face(at.i) || !has_face(row(large.tile, at.i).opp);
    });
    hidden::for_each_asked(large, within, 16,
                           [&](const HalfEdgeTable& he, const InLargeMesh& at) {
                               REQUIRE(boundary_walk(he, at.row()).empty());
                           });

    const Border border(large.tile);
    constexpr int long_walks = 40;
    const std::vector<int> loop = border.loops().front();
    for (int k = 0; k < long_walks; ++k) {
        const int on_border = loop[static_cast<std::size_t>(k) % loop.size()];
        const InLargeMesh at{
            &large, k % 2 == 0 ? on_border : row(large.tile, on_border).opp, k};
        const ReadBudget budget(
            large.he, 32 * static_cast<std::int64_t>(loop.size()) + 16);
        REQUIRE_THAT(boundary_walk(large.he, at.row()),
                     IsRotationOf(at.half_edges(border.walk(at.i))));
    }
}

}  // namespace course::walk_checks
