// Looks at the first edge that two faces share, and not at the second.
// Hint: You look at one edge that two faces share, and not at the others.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <map>
#include <set>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, std::pair<int, bool>> first;
    std::set<std::pair<int, int>> compared;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k], to = face[(k + 1) % face.size()];
            auto edge = std::pair(from < to ? from : to, from < to ? to : from);
            auto found = first.find(edge);
            if (found == first.end()) {
                first[edge] = {f, from < to};
                continue;
            }
            if (!compared.insert({found->second.first, f}).second) continue;
            if (found->second.second == (from < to)) return false;
        }
    }
    return true;
}
