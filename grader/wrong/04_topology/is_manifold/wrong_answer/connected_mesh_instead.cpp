// Asks whether the mesh as a whole is connected, and not the faces at each vertex.
// Hint: You ask whether the mesh hangs together, and not whether the faces at
// each vertex do.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

bool is_manifold(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces;
    std::map<int, std::vector<int>> beside;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k], b = face[(k + 1) % face.size()];
            if (++faces[{std::min(a, b), std::max(a, b)}] > 2) return false;
            beside[a].push_back(b);
            beside[b].push_back(a);
        }
    if (beside.empty()) return true;
    std::set<int> seen = {beside.begin()->first};
    std::vector<int> todo = {beside.begin()->first};
    while (!todo.empty()) {
        int v = todo.back();
        todo.pop_back();
        for (int w : beside[v])
            if (seen.insert(w).second) todo.push_back(w);
    }
    return seen.size() == beside.size();
}
