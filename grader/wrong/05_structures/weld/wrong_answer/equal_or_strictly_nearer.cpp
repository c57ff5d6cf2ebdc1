// Joins equal points and nearer ones, but not at just the distance eps.
// Hint: You keep points apart whose distance is eps itself.
#include "exercises/05_structures/weld.h"

namespace {

int vertex_at(std::vector<Vec3>& positions, Vec3 p, double eps) {
    for (std::size_t v = 0; v < positions.size(); ++v) {
        Vec3 d = positions[v] - p;
        if (positions[v] == p || length(d) < eps) return static_cast<int>(v);
    }
    positions.push_back(p);
    return static_cast<int>(positions.size()) - 1;
}

}  // namespace

IndexedMesh weld(std::span<const SoupTriangle> soup, double eps) {
    if (!(eps >= 0)) throw std::invalid_argument("eps");
    IndexedMesh mesh;
    for (const SoupTriangle& t : soup) {
        int a = vertex_at(mesh.positions, t[0], eps);
        int b = vertex_at(mesh.positions, t[1], eps);
        int c = vertex_at(mesh.positions, t[2], eps);
        mesh.faces.push_back({a, b, c});
    }
    return mesh;
}
