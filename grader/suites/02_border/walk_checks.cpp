#include "grader/suites/02_border/walk_checks.h"

#include <algorithm>

#include "course/runner/suite.h"
#include "grader/suites/02_border/oracle.h"

namespace course::walk_checks {

namespace {

const HalfEdge& row(const Fixture& fixture, int i) {
    return fixture.he.rows()[static_cast<std::size_t>(i)];
}

}  // namespace

void from_the_border(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    for (const int i : oracle::sample(fixture.he))
        if (border.has(i))
            CHECK_THAT(boundary_walk(fixture.he, i),
                       IsRotationOf(border.walk(i)));
}

void from_beside_the_border(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    for (const int i : oracle::sample(fixture.he))
        if (!border.has(i) && border.faces_at(i) == 1)
            CHECK_THAT(boundary_walk(fixture.he, i),
                       IsRotationOf(border.walk(i)));
}

void from_within(Walk boundary_walk, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    for (const int i : oracle::sample(fixture.he))
        if (border.faces_at(i) == 2)
            CHECK(boundary_walk(fixture.he, i) == std::vector<int>{});
}

void from_everywhere(Walk boundary_walk, const Fixture& fixture) {
    from_the_border(boundary_walk, fixture);
    from_beside_the_border(boundary_walk, fixture);
    from_within(boundary_walk, fixture);
}

void cost(Walk boundary_walk) {
    const Fixture& large = a_million_half_edges();
    std::vector<int> within;
    for (int k = 0; k < many_calls; ++k) {
        const int i = k * (large.he.size() / many_calls);
        if (row(large, i).fi != -1 && row(large, row(large, i).opp).fi != -1)
            within.push_back(i);
    }
    const AskAhead ahead(large.he, within);
    for (const int i : within) {
        const ReadBudget budget(large.he, 16);
        REQUIRE(boundary_walk(large.he, i).empty());
    }

    const std::vector<int> border = oracle::border_rows(large.he);
    std::vector<int> loop = {border.front()};
    while (row(large, loop.back()).next != loop.front())
        loop.push_back(row(large, loop.back()).next);
    const auto length = static_cast<int>(loop.size());
    constexpr int long_walks = 40;
    for (int k = 0; k < long_walks; ++k) {
        const int at_border =
            loop[static_cast<std::size_t>(k * (length - 1) / (long_walks - 1))];
        const int i = k % 2 == 0 ? at_border : row(large, at_border).opp;
        const ReadBudget budget(large.he, 32 * length + 16);
        std::vector<int> walk = boundary_walk(large.he, i);
        const auto first = std::find(walk.begin(), walk.end(), loop.front());
        std::rotate(walk.begin(), first, walk.end());
        REQUIRE(walk == loop);
    }
}

}  // namespace course::walk_checks
