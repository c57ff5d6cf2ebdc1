// Writes coordinates in hexadecimal: exact, but no decimals.
// Hint: You write coordinates that are no decimals.
#include "exercises/07_files/write_off.h"

#include <limits>
#include <sstream>

std::string write_off(const IndexedMesh& mesh) {
    if (!mesh.loose_edges.empty())
        throw std::invalid_argument(std::to_string(mesh.loose_edges.size()) +
                                    " loose edges: OFF has no form for them");
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << std::hexfloat;

    out << "OFF\n" << mesh.vertex_count() << ' ' << mesh.faces.size() << " 0\n";
    for (Vec3 p : mesh.positions)
        out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (FaceList::Face face : mesh.faces) {
        out << face.size();
        for (int v : face) out << ' ' << v;
        out << '\n';
    }
    return out.str();
}
