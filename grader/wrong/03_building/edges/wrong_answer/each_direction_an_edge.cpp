// Files a side by start and end: an inner edge comes twice.
#include "exercises/03_building/edges.h"

#include <map>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces_of;
    for (FaceList::Face face : mesh.faces) {
        int from = face.back();
        for (int to : face) {
            ++faces_of[{from, to}];
            from = to;
        }
    }
    std::vector<EdgeInfo> list;
    for (const auto& [ends, faces] : faces_of)
        list.push_back({ends.first, ends.second, faces});
    for (const auto& [a, b] : mesh.loose_edges) list.push_back({a, b, 0});
    return list;
}
