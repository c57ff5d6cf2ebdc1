// What is no manifold: an edge with three faces, for which the table has no
// place, and a vertex with two fans, of which a walk may miss one.
#include <algorithm>
#include <set>

#include "course/halfedge/build.h"
#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/elements.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

/// One defect: what the builder says, and which way each face runs.
Json defective(const IndexedMesh& mesh, const Defect& defect) {
    const int a = defect.vertices.at(0);
    const int b = defect.vertices.at(1);
    std::vector<Json> uses;
    for (const int f : defect.faces) {
        const bool forward = has_side(mesh.faces[f], a, b);
        uses.push_back(Json::object(
            {{"face", f}, {"from", forward ? a : b}, {"to", forward ? b : a}}));
    }
    return Json::object({{"edge", defect.vertices},
                         {"uses", uses},
                         {"says", to_string(defect)}});
}

Json refused(const char* name, const IndexedMesh& mesh) {
    std::vector<Json> found;
    try {
        build(mesh);
    } catch (const BuildError& error) {
        for (const Defect& defect : error.defects())
            found.push_back(defective(mesh, defect));
    }
    return Json::object({{"name", name},
                         {"points", mesh.positions},
                         {"faces", mesh.faces},
                         {"defects", found}});
}

std::vector<int> neighbours(const FaceList& faces, int v) {
    std::set<int> found;
    for (const FaceList::Face face : faces)
        for (const int u : face)
            if (has_side(face, u, v) || has_side(face, v, u)) found.insert(u);
    return {found.begin(), found.end()};
}

/// The walk round the vertex with several fans: it may miss one.
Json walked(const char* name, const Fixture& fixture) {
    const HalfEdgeTable& he = fixture.he;
    const int v = bow_tie_vertices(fixture.mesh).at(0);
    const int start = leaving(he, v);
    std::vector<int> walk;
    int i = start;
    do {
        walk.push_back(i);
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    return Json::object({{"name", name},
                         {"points", fixture.mesh.positions},
                         {"faces", fixture.mesh.faces},
                         {"table", he.rows()},
                         {"vertex", v},
                         {"neighbours", neighbours(fixture.mesh.faces, v)},
                         {"walk", walk}});
}

}  // namespace

std::string nonmanifold_picture() {
    return Json::object(
               {{"edges", Json::array({refused("three pages", zoo::fan3().mesh),
                                       refused("house with a wall",
                                               zoo::house_with_wall().mesh)})},
                {"vertices",
                 Json::array(
                     {walked("bow-tie, two loops", zoo::bow_tie_separate()),
                      walked("bow-tie, one loop", zoo::bow_tie_crossed()),
                      walked("hourglass", zoo::hourglass())})}})
        .text();
}

}  // namespace course
