// Does not write how many corners a face has.
// Hint: You do not write how many corners a face has.
#include "exercises/07_files/write_off.h"

#include <limits>
#include <sstream>

std::string write_off(const IndexedMesh& mesh) {
    if (!mesh.loose_edges.empty())
        throw std::invalid_argument(std::to_string(mesh.loose_edges.size()) +
                                    " loose edges: OFF has no form for them");
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);

    out << "OFF\n" << mesh.vertex_count() << ' ' << mesh.faces.size() << " 0\n";
    for (Vec3 p : mesh.positions)
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (FaceList::Face face : mesh.faces) {
        for (int v : face) out << v << ' ';
        out << '\n';
    }
    return out.str();
}
