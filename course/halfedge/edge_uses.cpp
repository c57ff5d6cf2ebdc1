// Which faces use which edge.
#include "course/halfedge/edge_uses.h"

#include <algorithm>

#include "course/halfedge/build.h"

namespace course {

bool has_distinct_corners(FaceList::Face corners) {
    constexpr std::size_t few = 16;
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

std::vector<EdgeUse> edge_uses(const IndexedMesh& mesh) {
    require_countable(mesh.positions.size(),
                      static_cast<std::size_t>(mesh.faces.size()),
                      mesh.faces.corners().size(), mesh.loose_edges.size());
    std::vector<EdgeUse> uses;
    uses.reserve(mesh.faces.corners().size());
    int corner = 0;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face corners = mesh.faces[f];
        const bool is_sound = is_sound_face(mesh, corners);
        for (std::size_t k = 0; k < corners.size(); ++k, ++corner) {
            if (!is_sound) continue;
            const int from = corners[k];
            const int to = corners[k + 1 < corners.size() ? k + 1 : 0];
            uses.push_back(
                {std::min(from, to), std::max(from, to), f, from > to, corner});
        }
    }
    std::sort(uses.begin(), uses.end());
    return uses;
}

const EdgeUse* end_of_edge(const EdgeUse* begin, const EdgeUse* end) {
    const EdgeUse* after = begin + 1;
    while (after != end && after->low == begin->low &&
           after->high == begin->high)
        ++after;
    return after;
}

}  // namespace course
