// Faces in the order in which the table comes to them.
// Hint: You number the faces in the order in which you meet them; the table
// says which is which.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    std::vector<bool> done(static_cast<std::size_t>(he.size()));
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1 || done[static_cast<std::size_t>(start)])
            continue;
        faces.emplace_back();
        int i = start;
        do {
            done[static_cast<std::size_t>(i)] = true;
            faces.back().push_back(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    return faces;
}
