// Fans out from vertex 0 of the mesh, not from corner 0 of the face.
// Hint: You take a vertex of the mesh for the corner of a face: your triangles
// have vertices that their face does not have.
#include "exercises/08_making/triangulate_convex.h"

#include <string>

IndexedMesh triangulate_convex(const IndexedMesh& mesh) {
    IndexedMesh cut = {mesh.positions, {}, mesh.loose_edges};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        if (face.size() < 3)
            throw std::invalid_argument("face " + std::to_string(f) + " has " +
                                        std::to_string(face.size()) +
                                        " corners, but needs three");
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            cut.faces.push_back({0, face[k], face[k + 1]});
    }
    return cut;
}
