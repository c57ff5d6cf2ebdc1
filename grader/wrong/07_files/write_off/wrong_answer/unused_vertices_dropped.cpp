// Writes vertices up to the last one that a face uses.
// Hint: You leave out vertices that nothing names.
#include "exercises/07_files/write_off.h"

#include <limits>
#include <sstream>

std::string write_off(const IndexedMesh& mesh) {
    if (!mesh.loose_edges.empty())
        throw std::invalid_argument(std::to_string(mesh.loose_edges.size()) +
                                    " loose edges: OFF has no form for them");
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);

    int used = 0;
    for (int v : mesh.faces.corners()) used = v + 1 > used ? v + 1 : used;
    out << "OFF\n" << used << ' ' << mesh.faces.size() << " 0\n";
    for (Vec3 p : std::span(mesh.positions).first(static_cast<std::size_t>(used)))
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (FaceList::Face face : mesh.faces) {
        out << face.size();
        for (int v : face) out << ' ' << v;
        out << '\n';
    }
    return out.str();
}
