// Adds up the directions along each edge and lets 1 and -1 pass.
// Hint: At an edge with more than two faces you miss two that run along it the
// same way.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <algorithm>
#include <map>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> sum;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            sum[std::minmax(from, to)] += from < to ? 1 : -1;
        }
    for (const auto& [edge, total] : sum)
        if (total > 1 || total < -1) return false;
    return true;
}
