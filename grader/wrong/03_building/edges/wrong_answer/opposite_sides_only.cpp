// Only a side that runs the other way belongs to the same edge.
// Hint: You take two sides for one edge only where they run opposite ways.
#include "exercises/03_building/edges.h"

#include <map>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> sides;
    for (FaceList::Face face : mesh.faces) {
        int from = face.back();
        for (int to : face) {
            ++sides[{from, to}];
            from = to;
        }
    }
    std::vector<EdgeInfo> list;
    for (const auto& [ends, n] : sides) {
        auto [a, b] = ends;
        auto across = sides.find({b, a});
        if (across == sides.end())
            for (int k = 0; k < n; ++k) list.push_back({a, b, 1});
        else if (a < b)
            list.push_back({a, b, n + across->second});
    }
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
