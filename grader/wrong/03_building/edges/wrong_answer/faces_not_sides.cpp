// A set of faces for each edge: one that comes twice counts once.
// Hint: You count faces; one face may run along an edge twice.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, std::set<int>> faces_of;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        int from = mesh.faces[f].back();
        for (int to : mesh.faces[f]) {
            faces_of[std::minmax({from, to})].insert(f);
            from = to;
        }
    }
    std::vector<EdgeInfo> list;
    for (const auto& [ends, faces] : faces_of)
        list.push_back(
            {ends.first, ends.second, static_cast<int>(faces.size())});
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
