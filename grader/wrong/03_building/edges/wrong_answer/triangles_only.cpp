// Three sides for each face, whatever it has.
// Hint: You take every face for a triangle.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <map>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces_of;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k)
            ++faces_of[std::minmax({face[k], face[(k + 1) % 3]})];
    std::vector<EdgeInfo> list;
    for (const auto& [ends, faces] : faces_of)
        list.push_back({ends.first, ends.second, faces});
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
