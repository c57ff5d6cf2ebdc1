#include "exercises/05_structures/weld.h"

#include <string>

namespace {

/// The number of the first vertex in reach of the point; made if there is none.
int vertex_at(std::vector<Vec3>& positions, Vec3 point, double eps) {
    int count = static_cast<int>(positions.size());
    for (int v = 0; v < count; ++v)
        if (length(positions[static_cast<std::size_t>(v)] - point) <= eps)
            return v;
    positions.push_back(point);
    return count;
}

}  // namespace

IndexedMesh weld(std::span<const SoupTriangle> soup, double eps) {
    if (!(eps >= 0))
        throw std::invalid_argument("eps is " + std::to_string(eps) +
                                    ", but a distance is 0 or more");
    IndexedMesh mesh;
    for (const SoupTriangle& triangle : soup) {
        int a = vertex_at(mesh.positions, triangle[0], eps);
        int b = vertex_at(mesh.positions, triangle[1], eps);
        int c = vertex_at(mesh.positions, triangle[2], eps);
        mesh.faces.push_back({a, b, c});
    }
    return mesh;
}
