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

inline bool anywhere(const oracle::ByFaces&, int) {
    return true;
}
inline bool has_face(const oracle::ByFaces& mesh, int i) {
    return mesh.face(i) != -1;
}
inline bool starts_within(const oracle::ByFaces& mesh, int i) {
    return mesh.place_of_vertex(i) == oracle::Place::interior;
}

/// The same for half-edges of a large mesh: those `where` it says so, out of
/// `calls`. Each check is one call, which may read `reads` half-edges.
template <class Where, class Check>
void for_some_of_a_million(int calls, std::int64_t reads, Where where,
                           Check check) {
    const Fixture& large = a_million_half_edges();
    std::vector<int> asked;
    for (int k = 0; k < calls; ++k)
        asked.push_back(k * (large.he.size() / calls));
    const oracle::ByFaces expected(large, asked);
    std::erase_if(asked, [&](int i) { return !where(expected, i); });
    const AskAhead ahead(large.he, asked);
    for (const int i : asked) {
        const ReadBudget budget(large.he, reads);
        check(large.he, i, expected);
    }
}

}  // namespace course::hidden
