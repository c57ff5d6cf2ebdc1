// Makes room for as many faces as the largest vertex number says.
// Hint: You use the number of a face as an index into a list that is too
// short.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    int most = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].vi > most) most = he[i].vi;
    std::vector<std::vector<int>> faces(static_cast<std::size_t>(most));
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1) continue;
        auto f = static_cast<std::size_t>(he[start].fi);
        if (!faces.at(f).empty()) continue;

        int i = start;
        do {
            faces[f].push_back(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    while (!faces.empty() && faces.back().empty()) faces.pop_back();
    return faces;
}
