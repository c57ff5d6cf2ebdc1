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

/// Whether there are three corners or more, all different. Linear; n log n for
/// many corners.
bool has_distinct_corners(FaceList::Face corners);

/// Whether they are vertices of the mesh, too. Inline for the sake of `build`,
/// and of its triangles.
[[gnu::always_inline]] inline bool is_sound_face(const IndexedMesh& mesh,
                                                 FaceList::Face corners) {
    const auto is_vertex = [n = mesh.vertex_count()](int v) {
        return v >= 0 && v < n;
    };
    if (corners.size() != 3)
        return std::all_of(corners.begin(), corners.end(), is_vertex) &&
               has_distinct_corners(corners);
    const int* const v = corners.data();
    return is_vertex(v[0]) && is_vertex(v[1]) && is_vertex(v[2]) &&
           v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
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
