// Takes 1-2 and 2-1 for two edges.
// Hint: You number an edge anew for each face that has it.
#include "exercises/05_structures/adjacency.h"

#include <algorithm>
#include <map>

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using EdgeNumbers = std::map<std::array<int, 2>, int>;

int edge_between(int a, int b, EdgeNumbers& numbers, Adjacency& lists) {
    std::array<int, 2> ends = {a, b};
    int next = static_cast<int>(lists.edges.size());
    auto [found, is_new] = numbers.emplace(ends, next);
    if (is_new) {
        lists.edges.push_back({ends, {}});
        for (int v : ends) lists.vertices[at(v)].edges.push_back(next);
    }
    return found->second;
}

}  // namespace

Adjacency adjacency(const IndexedMesh& mesh) {
    Adjacency lists;
    lists.vertices.resize(mesh.positions.size());
    EdgeNumbers numbers;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face corners = mesh.faces[f];
        FaceLinks face;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            int a = corners[i];
            int b = corners[(i + 1) % corners.size()];
            int e = edge_between(a, b, numbers, lists);
            face.vertices.push_back(a);
            face.edges.push_back(e);
            lists.vertices[at(a)].faces.push_back(f);
            lists.edges[at(e)].faces.push_back(f);
        }
        lists.faces.push_back(face);
    }
    for (auto [a, b] : mesh.loose_edges) edge_between(a, b, numbers, lists);
    return lists;
}
