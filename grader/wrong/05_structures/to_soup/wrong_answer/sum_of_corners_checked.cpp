// Counts all corners together: a face with four makes up for one with two.
// Hint: You accept a mesh in which some face has not just three corners.
#include "exercises/05_structures/to_soup.h"

namespace {

Vec3 at(const IndexedMesh& mesh, int v) {
    return mesh.positions.at(static_cast<std::size_t>(v));
}

}  // namespace

Soup to_soup(const IndexedMesh& mesh) {
    if (mesh.faces.corners().size() != 3 * static_cast<std::size_t>(mesh.faces.size()))
        throw std::invalid_argument("not only triangles");
    Soup soup;
    for (FaceList::Face face : mesh.faces) {
        std::size_t k = 3 * soup.size();
        soup.push_back({at(mesh, mesh.faces.corners()[k]), at(mesh, mesh.faces.corners()[k + 1]),
                        at(mesh, mesh.faces.corners()[k + 2])});
        if (face.empty()) soup.pop_back();
    }
    return soup;
}
