// The side from the last corner to the first is missing.
// Hint: You leave out the side from the last corner back to the first.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size() - 1; ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            if (!sides.insert({from, to}).second) return false;
        }
    return true;
}
