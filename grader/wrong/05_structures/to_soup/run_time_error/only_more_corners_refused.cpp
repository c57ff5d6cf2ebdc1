// Refuses faces with more than three corners, not those with fewer.
// Hint: You accept a mesh in which some face has not just three corners, or
// refuse it for another reason.
#include "exercises/05_structures/to_soup.h"

namespace {

Vec3 at(const IndexedMesh& mesh, int v) {
    return mesh.positions.at(static_cast<std::size_t>(v));
}

}  // namespace

Soup to_soup(const IndexedMesh& mesh) {
    for (FaceList::Face face : mesh.faces)
        if (face.size() > 3) throw std::invalid_argument("no triangle");
    Soup soup;
    for (FaceList::Face face : mesh.faces) {
        SoupTriangle triangle;
        for (std::size_t k = 0; k < face.size(); ++k) triangle[k] = at(mesh, face[k]);
        soup.push_back(triangle);
    }
    return soup;
}
