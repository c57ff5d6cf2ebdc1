// Looks at three sides of each face.
// Hint: You take every face for a triangle.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            int from = face[k];
            int to = face[(k + 1) % 3];
            if (!sides.insert({from, to}).second) return false;
        }
    return true;
}
