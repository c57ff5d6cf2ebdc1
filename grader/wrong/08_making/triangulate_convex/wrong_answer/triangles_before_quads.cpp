// All triangles come first, then what was cut.
// Hint: Your triangles are the right ones, and not in the order of their
// faces.
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
            cut.faces.push_back({face[0], face[k], face[k + 1]});
    }
    FaceList sorted;
    for (bool of_triangles : {true, false}) {
        int t = 0;
        for (int f = 0; f < mesh.faces.size(); ++f)
            for (std::size_t k = 2; k < mesh.faces[f].size(); ++k, ++t)
                if ((mesh.faces[f].size() == 3) == of_triangles)
                    sorted.push_back(cut.faces[t]);
    }
    cut.faces = sorted;
    return cut;
}
