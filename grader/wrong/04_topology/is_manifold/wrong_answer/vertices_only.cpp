// Asks the vertices and not the edges: three faces at an edge are one fan, too.
// Hint: You accept an edge that has more than two faces.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

/// What the faces at a vertex join there: the other ends of its edges.
using Joined = std::map<int, std::vector<int>>;

bool is_one_fan(const Joined& joined) {
    int start = joined.begin()->first;
    std::set<int> seen = {start};
    std::vector<int> todo = {start};
    while (!todo.empty()) {
        int end = todo.back();
        todo.pop_back();
        for (int other : joined.at(end))
            if (seen.insert(other).second) todo.push_back(other);
    }
    return seen.size() == joined.size();
}

}  // namespace

bool is_manifold(const IndexedMesh& mesh) {
    std::vector<Joined> at(mesh.positions.size());
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int before = face[(k + face.size() - 1) % face.size()];
            int after = face[(k + 1) % face.size()];
            Joined& joined = at[static_cast<std::size_t>(face[k])];
            joined[before].push_back(after);
            joined[after].push_back(before);
        }
    for (const Joined& joined : at)
        if (!joined.empty() && !is_one_fan(joined)) return false;
    return true;
}
