// Takes it for consistent when all normals point up, as on flat meshes.
// Hint: You look at where the faces point; what counts is how neighbours run
// along their edge.
#include "exercises/04_topology/is_consistently_oriented.h"

bool is_consistently_oriented(const IndexedMesh& mesh) {
    bool up = false, down = false;
    for (FaceList::Face face : mesh.faces) {
        auto p = [&](std::size_t k) {
            return mesh.positions[static_cast<std::size_t>(face[k])];
        };
        double z = cross(p(1) - p(0), p(2) - p(0)).z;
        up = up || z > 0;
        down = down || z < 0;
    }
    return !(up && down);
}
