// V - E + F, counted element by element: each face after those of its vertices
// and edges that did not come before. Then the parts of Euler's equation:
// pieces, border loops, handles.
#include <algorithm>
#include <map>
#include <set>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/elements.h"
#include "course/player/pictures/orientation.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

using Edge = std::pair<int, int>;  // the smaller end first
using Edges = std::vector<Edge>;

Edges edges_of(FaceList::Face corners) {
    Edges edges;
    for (const auto [from, to] : sides_of(corners))
        edges.push_back(std::minmax({from, to}));
    return edges;
}

Json json_of(const Edge& edge) {
    return Json::array({edge.first, edge.second});
}

std::vector<Json> elements(const FaceList& faces) {
    std::vector<Json> found;
    std::set<int> vertices;
    std::set<Edge> edges;
    for (int f = 0; f < faces.size(); ++f) {
        for (const int v : faces[f])
            if (vertices.insert(v).second)
                found.push_back(Json::object({{"vertex", v}}));
        for (const Edge& edge : edges_of(faces[f]))
            if (edges.insert(edge).second)
                found.push_back(Json::object({{"edge", json_of(edge)}}));
        found.push_back(Json::object({{"face", f}}));
    }
    return found;
}

/// Each edge with the number of its faces.
std::map<Edge, int> faces_at_edges(const FaceList& faces) {
    std::map<Edge, int> count;
    for (const FaceList::Face face : faces)
        for (const Edge& edge : edges_of(face)) ++count[edge];
    return count;
}

/// The edges in groups that hang together at vertices.
std::vector<Edges> connected(const Edges& edges) {
    std::map<int, int> group_at;  // a vertex belongs to the group of its edges
    for (const Edge& edge : edges) {
        const auto [a, a_is_new] = group_at.insert({edge.first, edge.first});
        const auto [b, b_is_new] = group_at.insert({edge.second, edge.second});
        const int from = b->second;
        const int to = a->second;
        for (auto& [v, group] : group_at)
            if (group == from) group = to;
    }
    std::map<int, Edges> groups;
    for (const Edge& edge : edges) groups[group_at[edge.first]].push_back(edge);
    std::vector<Edges> all;
    for (auto& [group, members] : groups) all.push_back(std::move(members));
    return all;
}

std::vector<Json> json_of(const std::vector<Edges>& groups) {
    std::vector<Json> all;
    for (const Edges& group : groups) {
        std::vector<Json> edges;
        for (const Edge& edge : group) edges.push_back(json_of(edge));
        all.emplace_back(edges);
    }
    return all;
}

/// How a mesh is best seen.
enum class View { as_it_is, cut_open };

Json counted(const char* name, const IndexedMesh& mesh,
             View view = View::as_it_is) {
    Edges edges;
    Edges border;
    for (const auto& [edge, faces] : faces_at_edges(mesh.faces)) {
        edges.push_back(edge);
        if (faces == 1) border.push_back(edge);
    }
    return Json::object({{"name", name},
                         {"net", view == View::cut_open},
                         {"points", mesh.positions},
                         {"faces", mesh.faces},
                         {"elements", elements(mesh.faces)},
                         {"pieces", json_of(connected(edges))},
                         {"loops", json_of(connected(border))},
                         {"orientable", is_orientable(mesh)},
                         {"bow_ties", bow_tie_vertices(mesh)}});
}

}  // namespace

std::string euler_picture() {
    return Json::object(
               {{"meshes",
                 Json::array({counted("slide", zoo::slide().mesh),
                              counted("tetrahedron", zoo::tetra().mesh),
                              counted("cube", zoo::cube().mesh),
                              counted("ring", zoo::annulus().mesh),
                              counted("two pieces", zoo::two_triangles().mesh),
                              counted("torus", torus(3, 3), View::cut_open),
                              counted("Möbius strip", zoo::moebius3q().mesh,
                                      View::cut_open),
                              counted("hourglass", zoo::hourglass().mesh,
                                      View::cut_open)})}})
        .text();
}

}  // namespace course
