// Builds the faces only.
// Hint: You leave out every loose edge.
#include "exercises/03_building/build.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

/// The half-edge from one vertex to another.
using FromTo = std::map<std::pair<int, int>, int>;

void refuse(const std::string& what) {
    throw std::invalid_argument(what);
}

void check_vertex(const IndexedMesh& mesh, int v) {
    if (v < 0 || v >= mesh.vertex_count())
        refuse("vertex " + std::to_string(v) + ": the mesh has 0.." +
               std::to_string(mesh.vertex_count() - 1));
}

void check_face(const IndexedMesh& mesh, int f) {
    FaceList::Face face = mesh.faces[f];
    const std::string name = "face " + std::to_string(f);
    if (face.size() < 3) refuse(name + ": fewer than three corners");
    for (int v : face) check_vertex(mesh, v);
    std::vector<int> corners(face.begin(), face.end());
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
        refuse(name + ": two corners at one vertex");
}

void file(FromTo& from_to, int from, int to, int i) {
    if (!from_to.insert({{from, to}, i}).second)
        refuse("two sides run from " + std::to_string(from) + " to " +
               std::to_string(to));
}

void add_face(HalfEdgeTable& he, FromTo& from_to, FaceList::Face face, int f) {
    int first = he.size();
    for (std::size_t k = 0; k < face.size(); ++k) {
        bool last = k + 1 == face.size();
        int i = he.size();
        he.push_back({face[k], f, last ? first : i + 1, -1});
        file(from_to, face[k], last ? face[0] : face[k + 1], i);
    }
}

/// Each half-edge gets its opposite; on the border it is a new one.
void add_opposites(HalfEdgeTable& he, const FromTo& from_to) {
    for (const auto& [ends, i] : from_to) {
        auto across = from_to.find({ends.second, ends.first});
        if (across != from_to.end()) {
            he[i].opp = across->second;
        } else {
            he[i].opp = he.size();
            he.push_back({ends.second, -1, -1, i});
        }
    }
}

void add_loose_edge(HalfEdgeTable& he, FromTo& from_to, int a, int b) {
    if (a == b) refuse("a loose edge from a vertex to itself");
    file(from_to, a, b, he.size());
    file(from_to, b, a, he.size() + 1);
    he.push_back({a, -1, -1, -1});
    he.push_back({b, -1, -1, -1});
}

/// Each border half-edge leads to one that leaves its tip, and takes it away.
void link_border(HalfEdgeTable& he) {
    std::map<int, std::vector<int>> leaving;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) leaving[he[i].vi].push_back(i);
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi != -1) continue;
        std::vector<int>& at_tip = leaving[he[he[i].opp].vi];
        he[i].next = at_tip.back();
        at_tip.pop_back();
    }
}

}  // namespace

HalfEdgeTable build(const IndexedMesh& mesh) {
    HalfEdgeTable he;
    FromTo from_to;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        check_face(mesh, f);
        add_face(he, from_to, mesh.faces[f], f);
    }
    for (const auto& [a, b] : mesh.loose_edges) {
        check_vertex(mesh, a);
        check_vertex(mesh, b);
    }
    add_opposites(he, from_to);
    link_border(he);
    return he;
}
