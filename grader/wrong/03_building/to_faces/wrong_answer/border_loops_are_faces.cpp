// The border loops come as faces at the end.
// Hint: You take the border for a face.
#include "exercises/03_building/to_faces.h"

#include <cstddef>

std::vector<std::vector<int>> to_faces(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> faces;
    std::vector<bool> seen(static_cast<std::size_t>(he.size()));
    std::vector<std::vector<int>> borders;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi == -1) {
            if (seen[static_cast<std::size_t>(start)]) continue;
            borders.emplace_back();
            int k = start;
            do {
                seen[static_cast<std::size_t>(k)] = true;
                borders.back().push_back(he[k].vi);
                k = he[k].next;
            } while (k != start);
            continue;
        }
        auto f = static_cast<std::size_t>(he[start].fi);
        if (f >= faces.size()) faces.resize(f + 1);
        if (!faces[f].empty()) continue;

        int i = start;
        do {
            faces[f].push_back(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    faces.insert(faces.end(), borders.begin(), borders.end());
    return faces;
}
