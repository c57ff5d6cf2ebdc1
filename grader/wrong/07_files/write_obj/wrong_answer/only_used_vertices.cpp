// Writes vertices up to the last one that something uses.
// Hint: You leave out vertices that nothing names.
#include "exercises/07_files/write_obj.h"

#include <limits>
#include <sstream>

std::string write_obj(const IndexedMesh& mesh) {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);

    int used = 0;
    for (int v : mesh.faces.corners()) used = v + 1 > used ? v + 1 : used;
    for (auto [a, b] : mesh.loose_edges)
        used = std::max(used, std::max(a, b) + 1);
    for (Vec3 p : std::span(mesh.positions).first(static_cast<std::size_t>(used)))
        out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (FaceList::Face face : mesh.faces) {
        out << 'f';
        for (int v : face) out << ' ' << v + 1;
        out << '\n';
    }
    for (auto [a, b] : mesh.loose_edges)
        out << "l " << a + 1 << ' ' << b + 1 << '\n';
    return out.str();
}
