// Ends the walk when a vertex comes again, which is no side yet of the start.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/03_building/to_faces.h"

#include <algorithm>
#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1) continue;
        auto f = static_cast<std::size_t>(he[start].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        if (!faces[f].empty()) continue;

        int i = start;
        do {
            faces[f].push_back(he[i].vi);
            i = he[i].next;
        } while (std::find(faces[f].begin(), faces[f].end(), he[i].vi) ==
                 faces[f].end());
    }
    return faces;
}
