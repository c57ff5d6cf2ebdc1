// Knows faces of up to four corners.
// Hint: You know triangles and quads only; faces may have more sides.
#include "exercises/06_geometry/signed_volume.h"

double signed_volume(const IndexedMesh& mesh) {
    if (mesh.faces.empty()) return 0;

    auto place = [&](int v) {
        return mesh.positions[static_cast<std::size_t>(v)];
    };
    Vec3 o = place(mesh.faces[0][0]);
    double six_volumes = 0;
    for (FaceList::Face face : mesh.faces) {
        Vec3 a = place(face[0]) - o;
        for (std::size_t k = 1; k + 1 < face.size() && k < 3; ++k) {
            Vec3 b = place(face[k]) - o;
            Vec3 c = place(face[k + 1]) - o;
            six_volumes += dot(a, cross(b, c));
        }
    }
    return six_volumes / 6;
}
