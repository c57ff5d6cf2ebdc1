// Reads three corners of each face.
// Hint: You take every face for a triangle.
#include "exercises/03_building/build_closed.h"

#include <map>
#include <utility>

HalfEdgeTable build_closed(const IndexedMesh& mesh) {
    HalfEdgeTable he;
    std::map<std::pair<int, int>, int> from_to;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        int first = he.size();
        for (std::size_t k = 0; k < 3; ++k) {
            bool last = k + 1 == 3;
            int i = he.size();
            he.push_back({face[k], f, last ? first : i + 1, -1});
            from_to[{face[k], last ? face[0] : face[k + 1]}] = i;
        }
    }
    for (const auto& [ends, i] : from_to)
        he[i].opp = from_to[{ends.second, ends.first}];
    return he;
}
