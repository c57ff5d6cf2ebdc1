// Counts in a list with a place for each vertex, before it knows whether the
// corner is one.
// Hint: You use the number at a corner as an index, also where it is no
// vertex.
#include "exercises/03_building/defects.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace {

using Defects = std::vector<MeshDefect>;

/// A face that has the edge, and whether it runs from the smaller end up.
struct Side {
    int face;
    bool up;
};
using SidesOfEdges = std::map<std::pair<int, int>, std::vector<Side>>;

/// Adds the defects of face f by itself; true when there are none.
bool check_face(const IndexedMesh& mesh, int f, Defects& found) {
    const std::size_t before = found.size();
    FaceList::Face face = mesh.faces[f];
    if (face.size() < 3) found.push_back({MeshFault::too_few_corners, {f}});
    std::vector<int> times(mesh.positions.size());
    std::set<int> repeated;
    int corner = 0;
    for (int v : face) {
        if (v < 0 || v >= mesh.vertex_count())
            found.push_back({MeshFault::index_out_of_range, {f, corner}});
        if (++times.at(static_cast<std::size_t>(v)) > 1) repeated.insert(v);
        ++corner;
    }
    for (int v : repeated)
        found.push_back({MeshFault::repeated_vertex, {f, v}});
    return found.size() == before;
}

SidesOfEdges sides_of_edges(const IndexedMesh& mesh,
                            const std::vector<int>& sound) {
    SidesOfEdges sides;
    for (int f : sound) {
        int from = mesh.faces[f].back();
        for (int to : mesh.faces[f]) {
            sides[std::minmax({from, to})].push_back({f, from < to});
            from = to;
        }
    }
    return sides;
}

void check_edges(const SidesOfEdges& sides_of, Defects& found) {
    for (const auto& [ends, sides] : sides_of) {
        bool alike = sides.size() == 2 && sides[0].up == sides[1].up;
        if (sides.size() < 3 && !alike) continue;
        MeshDefect defect{
            alike ? MeshFault::wound_alike : MeshFault::too_many_faces,
            {ends.first, ends.second}};
        for (Side side : sides) defect.elements.push_back(side.face);
        found.push_back(defect);
    }
}

void check_duplicates(const IndexedMesh& mesh, const std::vector<int>& sound,
                      Defects& found) {
    std::map<std::vector<int>, std::vector<int>> faces_with;
    for (int f : sound) {
        std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()),
                    face.end());
        faces_with[face].push_back(f);
    }
    for (const auto& [face, faces] : faces_with)
        if (faces.size() > 1)
            found.push_back({MeshFault::duplicate_faces, faces});
}

/// Which faces at one vertex share an edge that ends there.
using Neighbours = std::map<int, std::vector<int>>;

void join_along(const std::vector<Side>& sides, Neighbours& at_vertex) {
    int before = sides.front().face;
    for (auto [face, up] : sides) {
        at_vertex[face].push_back(before);
        at_vertex[before].push_back(face);
        before = face;
    }
}

bool is_one_fan(const Neighbours& at_vertex) {
    std::vector<int> todo = {at_vertex.begin()->first};
    std::set<int> reached(todo.begin(), todo.end());
    while (!todo.empty()) {
        int f = todo.back();
        todo.pop_back();
        for (int g : at_vertex.at(f))
            if (reached.insert(g).second) todo.push_back(g);
    }
    return reached.size() == at_vertex.size();
}

void check_vertices(const SidesOfEdges& sides_of, Defects& found) {
    std::map<int, Neighbours> neighbours_at;
    for (const auto& [ends, sides] : sides_of) {
        join_along(sides, neighbours_at[ends.first]);
        join_along(sides, neighbours_at[ends.second]);
    }
    for (const auto& [v, at_vertex] : neighbours_at)
        if (!is_one_fan(at_vertex))
            found.push_back({MeshFault::several_fans, {v}});
}

}  // namespace

std::vector<MeshDefect> defects(const IndexedMesh& mesh) {
    Defects found;
    std::vector<int> sound;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (check_face(mesh, f, found)) sound.push_back(f);
    SidesOfEdges sides_of = sides_of_edges(mesh, sound);
    check_edges(sides_of, found);
    check_duplicates(mesh, sound, found);
    check_vertices(sides_of, found);
    return found;
}
