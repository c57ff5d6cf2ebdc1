// Adds the two numbers: neither the direction nor the edge can be told.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<int> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            if (!sides.insert(3 * from + to).second) return false;
        }
    return true;
}
