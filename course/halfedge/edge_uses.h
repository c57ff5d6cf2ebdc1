// Which faces use which edge: the sides of all faces, sorted by edge. What is
// asked of a mesh that may have no half-edge table.
#pragma once

#include <algorithm>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// A side of a face, as its edge sees it.
struct EdgeUse {
    int low, high;  ///< the ends of the edge, low < high
    int face;
    bool falling;  ///< the face runs from the larger end to the smaller
    int corner;    ///< where the side begins, in faces.corners()

    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Whether a face has three corners or more, all different. Inline for the sake
/// of `build`. Linear; n log n for many corners.
inline bool has_distinct_corners(FaceList::Face corners) {
    constexpr std::size_t few = 16;
    if (corners.size() == 3)
        return corners[0] != corners[1] && corners[1] != corners[2] &&
               corners[2] != corners[0];
    if (corners.size() > few) {
        std::vector<int> sorted(corners.begin(), corners.end());
        std::sort(sorted.begin(), sorted.end());
        return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    }
    for (std::size_t k = 1; k < corners.size(); ++k)
        for (std::size_t j = 0; j < k; ++j)
            if (corners[j] == corners[k]) return false;
    return corners.size() >= 3;
}

/// Whether its corners are vertices of the mesh, too.
inline bool is_sound_face(const IndexedMesh& mesh, FaceList::Face corners) {
    for (const int v : corners)
        if (v < 0 || v >= mesh.vertex_count()) return false;
    return has_distinct_corners(corners);
}

/// The sides of the faces that are sound, by edge and then by face: the uses of
/// an edge stand side by side. O(n log n).
/// Throws std::length_error when int cannot number them (require_countable).
std::vector<EdgeUse> edge_uses(const IndexedMesh& mesh);

/// Where the uses of the edge of *begin end.
const EdgeUse* end_of_edge(const EdgeUse* begin, const EdgeUse* end);

/// Calls `act` with the uses of each edge, as [begin, end).
template <class Act>
void for_each_edge(const std::vector<EdgeUse>& uses, Act act) {
    const EdgeUse* const end = uses.data() + uses.size();
    for (const EdgeUse* begin = uses.data(); begin != end;) {
        const EdgeUse* const after = end_of_edge(begin, end);
        act(begin, after);
        begin = after;
    }
}

}  // namespace course
