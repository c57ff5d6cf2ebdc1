// Sorts and counts equal neighbours, but the last edge is never written down.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::vector<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces) {
        int from = face.back();
        for (int to : face) {
            sides.push_back(std::minmax({from, to}));
            from = to;
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<EdgeInfo> list;
    int count = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        if (k > 0 && sides[k] != sides[k - 1]) {
            list.push_back({sides[k - 1].first, sides[k - 1].second, count});
            count = 0;
        }
        ++count;
    }
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
