// Makes a square table with a mark for each pair of vertices.
// Hint: Your answers are right, but your memory grows with the square of
// the mesh.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <vector>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    auto n = static_cast<std::size_t>(mesh.vertex_count());
    std::vector<std::vector<int>> sides(n, std::vector<int>(8 * n));
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            auto from = static_cast<std::size_t>(face[k]);
            auto to = static_cast<std::size_t>(face[(k + 1) % face.size()]);
            if (sides[from][to]++ > 0) return false;
        }
    return true;
}
