// Cuts a face into a strip, to and fro: triangles that cover it, but no fan.
// Hint: You cut the faces into triangles, but not into a fan: all of its
// triangles meet in one corner.
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
        std::size_t low = 0, high = face.size() - 1;
        bool from_low = true;
        while (high - low >= 2) {
            cut.faces.push_back({face[low], face[from_low ? low + 1 : high - 1],
                                 face[high]});
            from_low ? ++low : --high;
            from_low = !from_low;
        }
    }
    return cut;
}
