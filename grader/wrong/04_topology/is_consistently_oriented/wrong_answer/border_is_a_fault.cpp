// Asks for the opposite of each side: open meshes have none.
// Hint: You take the border for a fault.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <utility>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int from = face[k];
            int to = face[(k + 1) % face.size()];
            sides.insert({from, to});
        }
    for (auto [from, to] : sides)
        if (sides.count({to, from}) == 0) return false;
    return true;
}
