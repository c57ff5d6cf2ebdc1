// Looks for the same far corner again for every face: quadratic.
// Hint: Your answers are right, but you go through the whole list again and
// again.
#include "exercises/06_geometry/signed_volume.h"

double signed_volume(const IndexedMesh& mesh) {
    double six_volumes = 0;
    for (FaceList::Face face : mesh.faces) {
        int lowest = face[0];
        for (FaceList::Face other : mesh.faces)
            for (int v : other)
                if (v < lowest) lowest = v;
        Vec3 o = mesh.positions[static_cast<std::size_t>(lowest)];
        Vec3 a = mesh.positions[static_cast<std::size_t>(face[0])] - o;
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            Vec3 b = mesh.positions[static_cast<std::size_t>(face[k])] - o;
            Vec3 c = mesh.positions[static_cast<std::size_t>(face[k + 1])] - o;
            six_volumes += dot(a, cross(b, c));
        }
    }
    return six_volumes / 6;
}
