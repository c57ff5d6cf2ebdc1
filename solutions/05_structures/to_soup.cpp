#include "exercises/05_structures/to_soup.h"

#include <string>

namespace {

void require_triangles(const IndexedMesh& mesh) {
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (mesh.faces[f].size() != 3)
            throw std::invalid_argument("face " + std::to_string(f) + " has " +
                                        std::to_string(mesh.faces[f].size()) +
                                        " corners, but a triangle has 3");
}

Vec3 position(const IndexedMesh& mesh, int v) {
    if (v < 0 || v >= mesh.vertex_count())
        throw std::out_of_range("vertex " + std::to_string(v) +
                                ": the mesh has " +
                                std::to_string(mesh.vertex_count()));
    return mesh.positions[static_cast<std::size_t>(v)];
}

}  // namespace

Soup to_soup(const IndexedMesh& mesh) {
    require_triangles(mesh);
    Soup soup;
    for (FaceList::Face face : mesh.faces)
        soup.push_back({position(mesh, face[0]), position(mesh, face[1]),
                        position(mesh, face[2])});
    return soup;
}
