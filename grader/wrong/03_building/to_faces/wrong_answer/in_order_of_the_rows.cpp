// Corners in the order of the table's rows, which is not the order of next.
// Hint: You take the corners in the order of the rows; next may lead
// another way.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi == -1) continue;
        auto f = static_cast<std::size_t>(he[i].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        faces[f].push_back(he[i].vi);
    }
    return faces;
}
