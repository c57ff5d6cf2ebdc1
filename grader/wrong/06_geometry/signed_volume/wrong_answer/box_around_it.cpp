// The volume of the box around the mesh.
// Hint: You give the volume of the box round the mesh.
#include "exercises/06_geometry/signed_volume.h"

#include <algorithm>

double signed_volume(const IndexedMesh& mesh) {
    if (mesh.faces.empty()) return 0;
    Vec3 low = mesh.positions[static_cast<std::size_t>(mesh.faces[0][0])];
    Vec3 high = low;
    for (int v : mesh.faces.corners()) {
        Vec3 p = mesh.positions[static_cast<std::size_t>(v)];
        low = {std::min(low.x, p.x), std::min(low.y, p.y),
               std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y),
                std::max(high.z, p.z)};
    }
    Vec3 size = high - low;
    return size.x * size.y * size.z;
}
