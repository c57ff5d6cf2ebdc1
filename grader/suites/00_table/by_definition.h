// What the suites of this chapter compare with: computed from the face list and
// from all rows at once, never by a walk.
#pragma once

#include <algorithm>
#include <vector>

#include "course/mesh/zoo.h"
#include "course/runner/suite.h"

namespace course::oracle {

inline const HalfEdge& row(const Fixture& fixture, int i) {
    return fixture.he.rows().at(static_cast<std::size_t>(i));
}

/// The corner that follows `vertex` in a face of the face list.
inline int corner_after(FaceList::Face face, int vertex) {
    const auto at = std::find(face.begin(), face.end(), vertex);
    return at + 1 == face.end() ? face.front() : *(at + 1);
}

/// The vertex that half-edge i arrives at: from the face list where i has a
/// face, else from its opposite.
inline int arrives_at(const Fixture& fixture, int i) {
    const HalfEdge& half_edge = row(fixture, i);
    if (half_edge.fi == -1) return row(fixture, half_edge.opp).vi;
    return corner_after(fixture.mesh.faces[half_edge.fi], half_edge.vi);
}

/// For each half-edge the one whose next it is: the column next, turned round.
inline std::vector<int> previous(const HalfEdgeTable& he) {
    std::vector<int> before(he.rows().size(), -1);
    for (int j = 0; j < he.size(); ++j)
        before.at(static_cast<std::size_t>(
            he.rows()[static_cast<std::size_t>(j)].next)) = j;
    return before;
}

/// The half-edges on the border: on a mesh with one border loop, its length.
inline std::vector<int> border(const Fixture& fixture) {
    std::vector<int> half_edges;
    for (int i = 0; i < fixture.he.size(); ++i)
        if (row(fixture, i).fi == -1) half_edges.push_back(i);
    return half_edges;
}

}  // namespace course::oracle
