// Asks how many sides the first face has, and there may be none.
// Hint: You look at the first face of a mesh that has none.
#include "exercises/03_building/build_closed.h"

#include <map>
#include <utility>
#include <vector>

HalfEdgeTable build_closed(const IndexedMesh& mesh) {
    HalfEdgeTable he;
    std::vector<int> sides;
    for (FaceList::Face face : mesh.faces)
        sides.push_back(static_cast<int>(face.size()));
    if (sides.at(0) < 3) return he;
    std::map<std::pair<int, int>, int> from_to;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        int first = he.size();
        for (std::size_t k = 0; k < face.size(); ++k) {
            bool last = k + 1 == face.size();
            int i = he.size();
            he.push_back({face[k], f, last ? first : i + 1, -1});
            from_to[{face[k], last ? face[0] : face[k + 1]}] = i;
        }
    }
    for (const auto& [ends, i] : from_to)
        he[i].opp = from_to.at({ends.second, ends.first});
    return he;
}
