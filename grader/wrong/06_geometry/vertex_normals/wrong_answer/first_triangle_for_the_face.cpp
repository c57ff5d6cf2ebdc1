// Takes the first three corners for the whole face.
// Hint: You take the first three corners for the whole face.
#include "exercises/06_geometry/vertex_normals.h"

namespace {

std::size_t at(int v) {
    return static_cast<std::size_t>(v);
}

}  // namespace

std::vector<Vec3> vertex_normals(const IndexedMesh& mesh) {
    std::vector<Vec3> sums(mesh.positions.size());
    std::vector<double> sizes(mesh.positions.size());

    for (FaceList::Face face : mesh.faces) {
        Vec3 first = mesh.positions[at(face[0])];
        Vec3 before = mesh.positions[at(face.back())];
        Vec3 area;
        double size = 0;
        for (int v : face) {
            Vec3 p = mesh.positions[at(v)];
            size += dot(p - before, p - before);
            before = p;
        }
        area = area_vector(first, mesh.positions[at(face[1])],
                           mesh.positions[at(face[2])]);
        for (int v : face) {
            sums[at(v)] = sums[at(v)] + area;
            sizes[at(v)] += size;
        }
    }

    for (std::size_t v = 0; v < sums.size(); ++v) {
        bool vanishes = length(sums[v]) <= 1e-12 * sizes[v];
        sums[v] = vanishes ? Vec3{} : (1 / length(sums[v])) * sums[v];
    }
    return sums;
}
