// Puts the coordinates through floats.
// Hint: You lose digits of the coordinates.
#include "exercises/05_structures/to_soup.h"

namespace {

Vec3 at(const IndexedMesh& mesh, int v) {
    Vec3 p = mesh.positions.at(static_cast<std::size_t>(v));
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
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
