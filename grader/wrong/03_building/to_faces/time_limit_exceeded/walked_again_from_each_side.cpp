// Begins each face anew from each of its sides: right, but n steps for each of n
// sides.
// Hint: Your answers are right, but you read the same rows of the table again
// and again.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1) continue;
        auto f = static_cast<std::size_t>(he[start].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        faces[f].clear();

        int i = start;
        do {
            faces[f].push_back(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    return faces;
}
