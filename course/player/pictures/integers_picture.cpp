// How many whole numbers each structure takes for a mesh: records are counted
// in real tables, and a record has as many numbers as its struct.
#include <algorithm>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/mesh/winged.h"
#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

static_assert(sizeof(HalfEdge) == 4 * sizeof(int));
static_assert(sizeof(WingedEdge) == 8 * sizeof(int));

/// What is counted in the structures of one mesh.
struct Sizes {
    int vertices, edges, faces, half_edges;
    int corners;     ///< half-edges that run along a face
    int edge_faces;  ///< edges and faces that touch, in pairs
};

Sizes sizes_of(const IndexedMesh& mesh, const HalfEdgeTable& he) {
    const auto with_face = std::count_if(
        he.begin(), he.end(), [](const HalfEdge& h) { return h.fi != -1; });
    return {mesh.vertex_count(),
            he.size() / 2,
            mesh.faces.size(),
            he.size(),
            static_cast<int>(mesh.faces.corners().size()),
            static_cast<int>(with_face)};
}

using Names = std::vector<std::string>;

/// Records of one kind: `fields` are the numbers of each, unless they are lists
/// with `numbers` entries altogether.
Json records(const char* of, int count, const Names& fields) {
    return Json::object({{"of", of},
                         {"records", count},
                         {"fields", fields},
                         {"numbers", count * static_cast<int>(fields.size())}});
}

Json lists(const char* of, int count, const char* entry, int numbers) {
    return Json::object({{"of", of},
                         {"records", count},
                         {"entry", entry},
                         {"numbers", numbers}});
}

Json structure(const char* name, const std::vector<Json>& parts) {
    return Json::object({{"name", name}, {"parts", parts}});
}

std::vector<Json> structures(const Sizes& n) {
    const Json corners = lists("face", n.faces, "vertex", n.corners);
    const Json half_edges =
        records("half-edge", n.half_edges, {"vi", "fi", "next", "opp"});
    const Names wings = {"from",      "to",         "left",    "right",
                         "from_left", "from_right", "to_left", "to_right"};
    return {
        structure("list of faces", {corners}),
        structure("faces and neighbours",
                  {corners, lists("face", n.faces, "face", n.corners)}),
        structure("half-edge table", {half_edges}),
        structure("half-edges, anchors",
                  {half_edges, records("vertex", n.vertices, {"half-edge"}),
                   records("face", n.faces, {"half-edge"})}),
        structure("winged edges, anchors",
                  {records("edge", n.edges, wings),
                   records("vertex", n.vertices, {"edge"}),
                   records("face", n.faces, {"edge"})}),
        structure("all adjacencies",
                  {lists("vertex", n.vertices, "edge", n.half_edges),
                   lists("vertex", n.vertices, "face", n.corners),
                   lists("edge", n.edges, "vertex", n.half_edges),
                   lists("edge", n.edges, "face", n.edge_faces),
                   lists("face", n.faces, "vertex", n.corners),
                   lists("face", n.faces, "edge", n.edge_faces)}),
    };
}

Json counted(const char* name, const char* face, const IndexedMesh& mesh) {
    const Sizes sizes = sizes_of(mesh, build(mesh));
    return Json::object({{"name", name},
                         {"face", face},
                         {"vertices", sizes.vertices},
                         {"edges", sizes.edges},
                         {"faces", sizes.faces},
                         {"structures", structures(sizes)}});
}

}  // namespace

std::string integers_picture() {
    return Json::object(
               {{"meshes",
                 Json::array({counted("torus7", "triangle", zoo::torus7().mesh),
                              counted("sphere", "triangle", icosphere(3)),
                              counted("torus of quads", "quad", torus(24, 16)),
                              counted("slide", "face", zoo::slide().mesh)})}})
        .text();
}

}  // namespace course
