// Throws std::out_of_range where the contract says std::invalid_argument.
// Hint: Where the contract refuses, your program ends with another error than
// the one that it names.
#include "exercises/08_making/triangulate_convex.h"

#include <string>

IndexedMesh triangulate_convex(const IndexedMesh& mesh) {
    IndexedMesh cut = {mesh.positions, {}, mesh.loose_edges};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        if (face.size() < 3)
            throw std::out_of_range("face " + std::to_string(f) + " has " +
                                        std::to_string(face.size()) +
                                        " corners, but needs three");
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            cut.faces.push_back({face[0], face[k], face[k + 1]});
    }
    return cut;
}
