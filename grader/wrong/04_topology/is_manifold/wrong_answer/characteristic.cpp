// Trusts Euler: V - E + F of a connected surface is at most 2.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <set>
#include <utility>

bool is_manifold(const IndexedMesh& mesh) {
    std::set<int> vertices;
    std::set<std::pair<int, int>> edges;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k], b = face[(k + 1) % face.size()];
            vertices.insert(a);
            edges.insert({std::min(a, b), std::max(a, b)});
        }
    return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
               mesh.faces.size() <=
           2;
}
