// Counts of a mesh by brute force over its face list, for tests that must not
// trust the half-edge table.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course::brute {

inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Each edge once, smaller end first, with the number of its faces.
inline std::map<std::pair<int, int>, int> edges_of(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            ++edges[std::minmax({face[k], face[(k + 1) % face.size()]})];
    for (const auto& loose : mesh.loose_edges)
        edges[std::minmax({loose[0], loose[1]})] += 0;
    return edges;
}

/// The faces of each edge, and whether they run along it upwards. Right where
/// no face comes to a vertex twice.
inline std::map<std::pair<int, int>, std::map<int, bool>> uses_of(
    const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, std::map<int, bool>> uses;
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t k = 0; k < mesh.faces[f].size(); ++k) {
            const int a = mesh.faces[f][k];
            const int b = mesh.faces[f][(k + 1) % mesh.faces[f].size()];
            uses[std::minmax(a, b)][f] = a < b;
        }
    return uses;
}

/// Whether the two faces of an edge run along it in the same direction.
inline bool is_alike(const std::map<int, bool>& two) {
    return two.begin()->second == two.rbegin()->second;
}

/// Whether the face has three corners or more, all different and vertices.
inline bool is_sound(const IndexedMesh& mesh, FaceList::Face face) {
    const std::set<int> distinct(face.begin(), face.end());
    return face.size() >= 3 && distinct.size() == face.size() &&
           *distinct.begin() >= 0 && *distinct.rbegin() < mesh.vertex_count();
}

/// The corners in order, from the smallest.
inline std::vector<int> from_smallest(FaceList::Face face) {
    std::vector<int> corners(face.begin(), face.end());
    std::rotate(corners.begin(),
                std::min_element(corners.begin(), corners.end()),
                corners.end());
    return corners;
}

/// All faces, each from its smallest corner.
inline std::vector<std::vector<int>> rotated_faces(const FaceList& faces) {
    std::vector<std::vector<int>> rotated;
    for (const auto face : faces) rotated.push_back(from_smallest(face));
    return rotated;
}

/// Sets of vertices that edges connect; vertices without an edge do not count.
inline std::vector<std::set<int>> components_of(const IndexedMesh& mesh) {
    std::vector<int> parent(mesh.positions.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[at(v)] != v)
            v = parent[at(v)] = parent[at(parent[at(v)])];
        return v;
    };
    const auto edges = edges_of(mesh);
    for (const auto& [edge, faces] : edges)
        parent[at(root(edge.first))] = root(edge.second);
    std::map<int, std::set<int>> sets;
    for (const auto& [edge, faces] : edges)
        for (const int v : {edge.first, edge.second}) sets[root(v)].insert(v);
    std::vector<std::set<int>> components;
    for (auto& [r, set] : sets) components.push_back(std::move(set));
    return components;
}

inline int vertices_of(const IndexedMesh& mesh) {
    int n = 0;
    for (const auto& component : components_of(mesh))
        n += static_cast<int>(component.size());
    return n;
}

inline int euler_of(const IndexedMesh& mesh) {
    return vertices_of(mesh) - static_cast<int>(edges_of(mesh).size()) +
           mesh.faces.size();
}

/// Lengths of the border loops of a table, ascending.
inline std::vector<int> loops_of(const HalfEdgeTable& he) {
    const std::vector<HalfEdge>& rows = he.rows();
    std::vector<bool> seen(rows.size(), false);
    std::vector<int> lengths;
    for (std::size_t start = 0; start < rows.size(); ++start) {
        if (rows[start].fi != -1 || seen[start]) continue;
        int length = 0;
        for (std::size_t i = start; !seen[i]; i = at(rows[i].next)) {
            seen[i] = true;
            ++length;
        }
        lengths.push_back(length);
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

/// Loops of border edges by brute force over the face list: the edges with one
/// face, joined at their ends. Right where no vertex has more than two.
inline int border_circles_of(const IndexedMesh& mesh) {
    IndexedMesh border;
    border.positions = mesh.positions;
    for (const auto& [edge, faces] : edges_of(mesh))
        if (faces == 1) border.loose_edges.push_back({edge.first, edge.second});
    return static_cast<int>(components_of(border).size());
}

/// Six times the volume that the faces enclose, each cut into a fan.
inline double six_volumes(const IndexedMesh& mesh) {
    double sum = 0;
    for (const auto& face : mesh.faces)
        for (std::size_t k = 2; k < face.size(); ++k)
            sum += dot(mesh.positions[at(face[0])],
                       cross(mesh.positions[at(face[k - 1])],
                             mesh.positions[at(face[k])]));
    return sum;
}

}  // namespace course::brute
