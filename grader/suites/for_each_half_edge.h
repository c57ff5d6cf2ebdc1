// The loops that the suites of walks share.
#pragma once

#include <cstdint>
#include <vector>

#include "course/runner/for_each_half_edge.h"
#include "grader/suites/meshes.h"

namespace course::hidden {

/// Calls check(he, i, expected) for each half-edge i of each fixture.
template <class Check>
void for_each_half_edge(const std::vector<Fixture>& fixtures, Check check) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        course::for_each_half_edge(fixture, check);
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

/// Calls check(he, at) for these half-edges of a large mesh. Each check is one
/// call f(he, at.row()), which may read `reads` half-edges.
template <class Check>
void for_each_asked(const LargeMesh& large,
                    const std::vector<InLargeMesh>& asked, std::int64_t reads,
                    Check check) {
    std::vector<int> rows;
    for (const InLargeMesh& at : asked) rows.push_back(at.row());
    const AskAhead ahead(large.he, rows);
    for (const InLargeMesh& at : asked) {
        const ReadBudget budget(large.he, reads);
        check(large.he, at);
    }
}

/// The same for those of `calls` half-edges of it where `where` says so, with
/// the answers that are expected of its tile.
template <class Where, class Check>
void for_some_of_a_million(int calls, std::int64_t reads, Where where,
                           Check check) {
    const LargeMesh& large = a_million_half_edges();
    const oracle::ByFaces expected(large.tile);
    std::vector<InLargeMesh> asked = some_of(large, calls);
    std::erase_if(
        asked, [&](const InLargeMesh& at) { return !where(expected, at.i); });
    for_each_asked(large, asked, reads,
                   [&](const HalfEdgeTable& he, const InLargeMesh& at) {
                       check(he, at, expected);
                   });
}

}  // namespace course::hidden
