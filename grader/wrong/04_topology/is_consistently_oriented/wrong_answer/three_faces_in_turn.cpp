// Compares each side with the last one along the same edge only: three faces may
// run forth, back and forth.
// Hint: At an edge with more than two faces you miss two that run along it the
// same way.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <algorithm>
#include <map>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, bool> last;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            bool up = from < to;
            auto edge = std::minmax(from, to);
            auto found = last.find(edge);
            if (found != last.end() && found->second == up) return false;
            last[edge] = up;
        }
    return true;
}
