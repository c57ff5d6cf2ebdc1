// The loops that the suites of walks share.
#pragma once

#include <cstdint>
#include <vector>

#include "course/runner/suite.h"
#include "grader/suites/meshes.h"
#include "grader/suites/oracle.h"

namespace course::hidden {

/// Calls check(he, i, expected) for each half-edge i of each fixture.
template <class Check>
void for_each_half_edge(const std::vector<Fixture>& fixtures, Check check) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const oracle::ByFaces expected(fixture);
        for (int i = 0; i < fixture.he.size(); ++i)
            check(fixture.he, i, expected);
    }
}

/// The same for `calls` half-edges of a large mesh; each check may read `reads`
/// of them.
template <class Check>
void for_some_of_a_million(int calls, std::int64_t reads, Check check) {
    const Fixture& large = a_million_half_edges();
    std::vector<int> asked;
    for (int k = 0; k < calls; ++k)
        asked.push_back(k * (large.he.size() / calls));
    const oracle::ByFaces expected(large, asked);
    for (const int i : asked) {
        const ReadBudget budget(large.he, reads);
        check(large.he, i, expected);
    }
}

}  // namespace course::hidden
