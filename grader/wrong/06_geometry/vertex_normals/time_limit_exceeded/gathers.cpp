// Searches the whole list for each vertex.
// Hint: Your answers are right, but you go through the whole list again and
// again.
#include "exercises/06_geometry/vertex_normals.h"

std::vector<Vec3> vertex_normals(const IndexedMesh& mesh) {
    std::vector<Vec3> normals;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        Vec3 sum;
        double size = 0;
        for (FaceList::Face face : mesh.faces)
            for (int corner : face) {
                if (corner != v) continue;
                Vec3 first = mesh.positions[static_cast<std::size_t>(face[0])];
                Vec3 before =
                    mesh.positions[static_cast<std::size_t>(face.back())];
                for (int w : face) {
                    Vec3 p = mesh.positions[static_cast<std::size_t>(w)];
                    sum = sum + area_vector(first, before, p);
                    size += dot(p - before, p - before);
                    before = p;
                }
            }
        bool vanishes = length(sum) <= 1e-12 * size;
        normals.push_back(vanishes ? Vec3{} : (1 / length(sum)) * sum);
    }
    return normals;
}
