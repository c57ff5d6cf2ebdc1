// Meets the corner out of range before the face that is no triangle.
// Hint: You accept a mesh in which some face has not just three corners, or
// refuse it for another reason.
#include "exercises/05_structures/to_soup.h"

namespace {

Vec3 at(const IndexedMesh& mesh, int v) {
    return mesh.positions.at(static_cast<std::size_t>(v));
}

}  // namespace

Soup to_soup(const IndexedMesh& mesh) {
    Soup soup;
    for (FaceList::Face face : mesh.faces) {
        if (face.size() != 3) throw std::invalid_argument("no triangle");
        soup.push_back({at(mesh, face[0]), at(mesh, face[1]), at(mesh, face[2])});
    }
    return soup;
}
