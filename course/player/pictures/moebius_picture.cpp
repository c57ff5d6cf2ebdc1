// Orientation: the sense of a face is passed on from neighbour to neighbour; on
// the Moebius strip it comes back reversed.
#include <algorithm>

#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/orientation.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

/// The mesh with face f wound the other way.
IndexedMesh with_turned(IndexedMesh mesh, int f) {
    FaceList faces;
    for (int g = 0; g < mesh.faces.size(); ++g) {
        std::vector<int> corners(mesh.faces[g].begin(), mesh.faces[g].end());
        if (g == f) std::reverse(corners.begin(), corners.end());
        faces.push_back(corners);
    }
    mesh.faces = faces;
    return mesh;
}

Json passed(const char* name, const IndexedMesh& mesh) {
    std::vector<Json> steps;
    for (const OrientationStep& s : pass_orientation(mesh))
        steps.push_back(
            Json::object({{"edge", Json::array({s.edge[0], s.edge[1]})},
                          {"face", s.face},
                          {"neighbour", s.neighbour},
                          {"alike", s.alike},
                          {"first", s.first}}));
    return Json::object(
        {{"name", name}, {"faces", mesh.faces}, {"steps", steps}});
}

}  // namespace

std::string moebius_picture() {
    const IndexedMesh ring = zoo::annulus().mesh;
    return Json::object(
               {{"strips",
                 Json::array(
                     {passed("ring", ring),
                      passed("ring, one face turned", with_turned(ring, 1)),
                      passed("Möbius strip", zoo::moebius3q().mesh),
                      passed("Möbius strip of triangles",
                             zoo::moebius5().mesh)})}})
        .text();
}

}  // namespace course
