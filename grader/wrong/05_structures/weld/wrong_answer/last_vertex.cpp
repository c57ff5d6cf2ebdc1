// Goes on looking after the first vertex in reach and takes the last.
// Hint: Where there are several points near a corner, you join it to another
// vertex than the contract says.
#include "exercises/05_structures/weld.h"

namespace {

int vertex_at(std::vector<Vec3>& positions, Vec3 p, double eps) {
    int found = -1;
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (length(positions[v] - p) <= eps) found = static_cast<int>(v);
    if (found >= 0) return found;
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
