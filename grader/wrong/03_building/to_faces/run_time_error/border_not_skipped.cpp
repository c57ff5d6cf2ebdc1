// Takes the border for a face, with number -1.
// Hint: You use the number of a face as an index, also where there is no face.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    for (int start = 0; start < he.size(); ++start) {
        auto f = static_cast<std::size_t>(he[start].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        if (!faces[f].empty()) continue;

        int i = start;
        do {
            faces[f].push_back(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    return faces;
}
