// Forgets the loose edges.
// Hint: You lose the loose edges.
#include "exercises/08_making/triangulate_convex.h"

#include <string>

IndexedMesh triangulate_convex(const IndexedMesh& mesh) {
    IndexedMesh cut = {mesh.positions, {}, {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        if (face.size() < 3)
            throw std::invalid_argument("face " + std::to_string(f) + " has " +
                                        std::to_string(face.size()) +
                                        " corners, but needs three");
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            cut.faces.push_back({face[0], face[k], face[k + 1]});
    }
    return cut;
}
