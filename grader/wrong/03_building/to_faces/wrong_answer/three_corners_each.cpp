// Takes every face for a triangle.
// Hint: You take every face for a triangle.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1) continue;
        auto f = static_cast<std::size_t>(he[start].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        if (!faces[f].empty()) continue;

        int second = he[start].next;
        int third = he[second].next;
        faces[f] = {he[start].vi, he[second].vi, he[third].vi};
    }
    return faces;
}
