// Says no for a mesh without faces.
// Hint: You say no because of something without a face: a loose edge, an
// unused vertex, or a mesh that has no faces.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            if (!sides.insert({from, to}).second) return false;
        }
    return !mesh.faces.empty();
}
