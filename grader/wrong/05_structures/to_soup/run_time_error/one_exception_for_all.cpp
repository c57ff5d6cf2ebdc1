// Throws std::invalid_argument for corners that are no vertices, too.
// Hint: You read a corner where the mesh has no such vertex, or refuse it with
// another exception than the contract names.
#include "exercises/05_structures/to_soup.h"

namespace {

Vec3 at(const IndexedMesh& mesh, int v) {
    if (v < 0 || v >= mesh.vertex_count()) throw std::invalid_argument("no vertex");
    return mesh.positions[static_cast<std::size_t>(v)];
}

}  // namespace

Soup to_soup(const IndexedMesh& mesh) {
    for (FaceList::Face face : mesh.faces)
        if (face.size() != 3) throw std::invalid_argument("no triangle");
    Soup soup;
    for (FaceList::Face face : mesh.faces) {
        soup.push_back({at(mesh, face[0]), at(mesh, face[1]), at(mesh, face[2])});
    }
    return soup;
}
