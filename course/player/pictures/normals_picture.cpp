#include "course/player/pictures/normals_picture.h"

#include "course/halfedge/build.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/reference.h"
#include "exercises/06_geometry/vertex_normal.h"

namespace course {

namespace {

WeighedTriangle weighed(const IndexedMesh& mesh, int f) {
    const FaceList::Face face = mesh.faces[f];
    const auto at = [&](int corner) {
        return mesh.positions[static_cast<std::size_t>(
            face[static_cast<std::size_t>(corner)])];
    };
    const Vec3 u = at(1) - at(0), v = at(2) - at(0), n = cross(u, v);
    return {f, (1 / length(n)) * n, length(n) / 2,
            std::atan2(length(n), dot(u, v))};
}

std::array<Vec3, 3> normals_of(const IndexedMesh& mesh) {
    const Reference<decltype(vertex_normal)> normal("vertex_normal");
    const HalfEdgeTable he = build(mesh);
    int start = 0;
    while (he[start].vi != 0) ++start;
    return {normal(he, mesh.positions, start, Weight::uniform),
            normal(he, mesh.positions, start, Weight::area),
            normal(he, mesh.positions, start, Weight::angle)};
}

Json corner_json(const WeighedCorner& corner) {
    std::vector<Json> triangles;
    for (const WeighedTriangle& t : corner.triangles)
        triangles.push_back(Json::object({{"face", t.face},
                                          {"normal", t.normal},
                                          {"area", t.area},
                                          {"angle", t.angle}}));
    return Json::object(
        {{"mesh", mesh_json(corner.mesh)},
         {"triangles", triangles},
         {"normals", Json::array({corner.normals[0], corner.normals[1],
                                  corner.normals[2]})}});
}

}  // namespace

WeighedCorner weighed_corner(Cut cut) {
    WeighedCorner corner{box_corner(cut), {}, {}};
    const FaceList& faces = corner.mesh.faces;
    for (int f = 0; f < faces.size(); ++f)
        if (faces[f][0] == 0)  // faces at the corner begin with it
            corner.triangles.push_back(weighed(corner.mesh, f));
    corner.normals = normals_of(corner.mesh);
    return corner;
}

std::string normals_picture() {
    return Json::object(
               {{"cuts",
                 Json::array({corner_json(weighed_corner(Cut::first)),
                              corner_json(weighed_corner(Cut::second))})}})
        .text();
}

}  // namespace course
