// The fields of an EdgeInfo have other names.
#include "exercises/03_building/edges.h"

#include <algorithm>
#include <map>
#include <utility>

std::vector<EdgeInfo> edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, EdgeInfo> found;
    for (FaceList::Face face : mesh.faces) {
        int from = face.back();
        for (int to : face) {
            EdgeInfo& edge = found[std::minmax({from, to})];
            edge.v0 = from;
            edge.v1 = to;
            ++edge.count;
            from = to;
        }
    }
    std::vector<EdgeInfo> list;
    for (const auto& [ends, edge] : found) list.push_back(edge);
    return list;
}
