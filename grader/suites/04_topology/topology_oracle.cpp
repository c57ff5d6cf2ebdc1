#include "grader/suites/04_topology/topology_oracle.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "grader/suites/02_border/oracle.h"

namespace course::oracle {

namespace {

using Ends = std::array<int, 2>;

std::vector<Ends> sides_of(FaceList::Face face) {
    std::vector<Ends> sides;
    for (std::size_t k = 0; k < face.size(); ++k)
        sides.push_back({face[k], face[(k + 1) % face.size()]});
    return sides;
}

std::vector<Ends> all_sides(const IndexedMesh& mesh) {
    std::vector<Ends> all;
    for (const FaceList::Face face : mesh.faces)
        for (const Ends& side : sides_of(face)) all.push_back(side);
    return all;
}

Ends sorted(Ends ends) {
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

/// Edges with the number of sides along them; loose edges have none.
std::map<Ends, int> edges_of(const IndexedMesh& mesh) {
    std::map<Ends, int> edges;
    for (const Ends& side : all_sides(mesh)) ++edges[sorted(side)];
    for (const auto& edge : mesh.loose_edges) edges[sorted(edge)] += 0;
    return edges;
}

bool has_repeats(std::vector<Ends> sides) {
    std::sort(sides.begin(), sides.end());
    return std::adjacent_find(sides.begin(), sides.end()) != sides.end();
}

}  // namespace

TopologyCounts topology_counts(const Fixture& fixture) {
    const std::map<Ends, int> edges = edges_of(fixture.mesh);
    std::set<int> vertices;
    for (const auto& [ends, sides] : edges)
        vertices.insert(ends.begin(), ends.end());
    return {static_cast<int>(vertices.size()), static_cast<int>(edges.size()),
            fixture.mesh.faces.size(),
            static_cast<int>(Border(fixture).loops().size())};
}

int side_count(const IndexedMesh& mesh) {
    return static_cast<int>(mesh.faces.corners().size());
}

bool every_edge_has_two_faces(const IndexedMesh& mesh) {
    const std::map<Ends, int> edges = edges_of(mesh);
    return std::all_of(edges.begin(), edges.end(),
                       [](const auto& edge) { return edge.second == 2; });
}

StoredLists stored_lists(const IndexedMesh& mesh) {
    std::map<int, std::vector<int>> faces_of_vertex;
    std::map<int, std::vector<Ends>> edges_of_vertex;
    std::map<Ends, std::vector<int>> faces_of_edge;
    StoredLists lists;
    for (const auto& edge : mesh.loose_edges) faces_of_edge[sorted(edge)];
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (const Ends& side : sides_of(mesh.faces[f])) {
            faces_of_vertex[side[0]].push_back(f);
            faces_of_edge[sorted(side)].push_back(f);
            ++lists.vertices_of_faces;
            ++lists.edges_of_faces;
        }
    for (const auto& [ends, faces] : faces_of_edge)
        for (const int v : ends) edges_of_vertex[v].push_back(ends);

    for (const auto& [v, faces] : faces_of_vertex)
        lists.faces_of_vertices += static_cast<int>(faces.size());
    for (const auto& [v, edges] : edges_of_vertex)
        lists.edges_of_vertices += static_cast<int>(edges.size());
    for (const auto& [ends, faces] : faces_of_edge) {
        lists.vertices_of_edges += static_cast<int>(ends.size());
        lists.faces_of_edges += static_cast<int>(faces.size());
    }
    return lists;
}

int graph_parts(const IndexedMesh& mesh) {
    const std::map<Ends, int> edges = edges_of(mesh);
    std::map<int, int> label;
    for (const auto& [ends, sides] : edges)
        for (const int v : ends) label[v] = v;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [ends, sides] : edges) {
            int& a = label[ends[0]];
            int& b = label[ends[1]];
            changed = changed || a != b;
            a = b = std::min(a, b);
        }
    }
    std::set<int> labels;
    for (const auto& [v, name] : label) labels.insert(name);
    return static_cast<int>(labels.size());
}

bool sides_agree(const IndexedMesh& mesh) {
    return !has_repeats(all_sides(mesh));
}

bool sides_agree_after(const IndexedMesh& mesh,
                       const std::vector<bool>& flags) {
    if (std::ssize(flags) != mesh.faces.size()) return false;
    std::vector<Ends> all;
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (Ends side : sides_of(mesh.faces[f])) {
            if (flags[static_cast<std::size_t>(f)]) std::swap(side[0], side[1]);
            all.push_back(side);
        }
    return !has_repeats(std::move(all));
}

bool some_flags_agree(const IndexedMesh& mesh) {
    const int n = mesh.faces.size();
    if (n == 0) return true;
    std::vector<bool> flags(static_cast<std::size_t>(n));
    for (unsigned bits = 0; bits < 1U << (n - 1); ++bits) {
        for (int f = 0; f < n; ++f)
            flags[static_cast<std::size_t>(f)] = ((bits >> f) & 1U) != 0;
        if (sides_agree_after(mesh, flags)) return true;
    }
    return false;
}

namespace {

/// The other ends of the two sides of a corner.
using Corner = Ends;

bool share_an_edge(const Corner& a, const Corner& b) {
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

/// Whether all corners are reached from the first one.
bool is_one_fan(std::vector<Corner> left) {
    std::vector<Corner> reached = {left.back()};
    left.pop_back();
    for (std::size_t k = 0; k < reached.size(); ++k)
        for (std::size_t j = left.size(); j-- > 0;)
            if (share_an_edge(reached[k], left[j])) {
                reached.push_back(left[j]);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
            }
    return left.empty();
}

}  // namespace

bool is_surface(const IndexedMesh& mesh) {
    const std::map<Ends, int> edges = edges_of(mesh);
    for (const auto& [ends, sides] : edges)
        if (sides > 2) return false;
    std::map<int, std::vector<Corner>> at_vertex;
    for (const FaceList::Face face : mesh.faces)
        for (std::size_t k = 0, n = face.size(); k < n; ++k)
            at_vertex[face[k]].push_back(
                {face[(k + n - 1) % n], face[(k + 1) % n]});
    return std::all_of(at_vertex.begin(), at_vertex.end(),
                       [](const auto& at) { return is_one_fan(at.second); });
}

}  // namespace course::oracle
