// Looks whether an edge has more than two faces, and calls that consistent.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <map>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            int a = from < to ? from : to, b = from < to ? to : from;
            if (++sides[{a, b}] > 2) return false;
        }
    return true;
}
