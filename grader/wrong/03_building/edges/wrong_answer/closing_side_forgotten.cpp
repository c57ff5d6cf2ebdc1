// The side from the last corner back to the first is left out.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <map>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces_of;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k + 1 < face.size(); ++k)
            ++faces_of[std::minmax({face[k], face[k + 1]})];
    std::vector<EdgeInfo> list;
    for (const auto& [ends, faces] : faces_of)
        list.push_back({ends.first, ends.second, faces});
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
