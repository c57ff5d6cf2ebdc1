// Adds at each corner the area vector of its wedge, not of the face.
// Hint: You let a face count at a corner by the two sides there, not by its
// area.
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
            area = area + area_vector(first, before, p);
            size += dot(p - before, p - before);
            before = p;
        }
        for (int v : face) {
            std::size_t k = 0;
            while (face[k] != v) ++k;
            std::size_t n = face.size();
            sums[at(v)] = sums[at(v)] +
                          area_vector(mesh.positions[at(face[(k + n - 1) % n])],
                                      mesh.positions[at(v)],
                                      mesh.positions[at(face[(k + 1) % n])]);
            sizes[at(v)] += size;
        }
    }

    for (std::size_t v = 0; v < sums.size(); ++v) {
        bool vanishes = length(sums[v]) <= 1e-12 * sizes[v];
        sums[v] = vanishes ? Vec3{} : (1 / length(sums[v])) * sums[v];
    }
    return sums;
}
