// Goes from the first face to its neighbours and theirs, and to no other part.
// Hint: You look at the first part of the mesh only.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <vector>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    if (mesh.faces.empty()) return true;
    std::set<std::pair<int, int>> sides;
    std::set<int> reached(mesh.faces[0].begin(), mesh.faces[0].end());
    std::vector<bool> done(static_cast<std::size_t>(mesh.faces.size()));
    for (bool more = true; more;) {
        more = false;
        for (int f = 0; f < mesh.faces.size(); ++f) {
            FaceList::Face face = mesh.faces[f];
            bool touches = false;
            for (int v : face) touches = touches || reached.count(v) > 0;
            if (!touches || done[static_cast<std::size_t>(f)]) continue;
            more = done[static_cast<std::size_t>(f)] = true;
            reached.insert(face.begin(), face.end());
            for (std::size_t k = 0; k < face.size(); ++k)
                if (!sides.insert({face[k], face[(k + 1) % face.size()]})
                         .second)
                    return false;
        }
    }
    return true;
}
