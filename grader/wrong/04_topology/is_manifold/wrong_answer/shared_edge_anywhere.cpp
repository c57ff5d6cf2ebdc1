// Links two faces at a vertex when they share an edge, even one that does not end
// at this vertex.
// Hint: At a vertex you link faces that have no edge in common there.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

bool is_manifold(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, std::vector<int>> faces;
    std::map<int, std::set<int>> at;
    std::vector<std::vector<int>> beside(
        static_cast<std::size_t>(mesh.faces.size()));
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k], b = face[(k + 1) % face.size()];
            at[a].insert(f);
            std::vector<int>& here = faces[{std::min(a, b), std::max(a, b)}];
            here.push_back(f);
            if (here.size() > 2) return false;
            if (here.size() < 2) continue;
            beside[static_cast<std::size_t>(here[0])].push_back(f);
            beside[static_cast<std::size_t>(f)].push_back(here[0]);
        }
    }
    for (auto& [v, left] : at) {
        std::vector<int> todo = {*left.begin()};
        left.erase(left.begin());
        while (!todo.empty()) {
            int f = todo.back();
            todo.pop_back();
            for (int g : beside[static_cast<std::size_t>(f)])
                if (left.erase(g) > 0) todo.push_back(g);
        }
        if (!left.empty()) return false;
    }
    return true;
}
