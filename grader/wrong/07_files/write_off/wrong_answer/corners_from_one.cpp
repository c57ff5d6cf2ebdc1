// Counts vertices from 1, as OBJ does.
// Hint: You count the vertices from 1.
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
        out << face.size();
        for (int v : face) out << ' ' << v + 1;
        out << '\n';
    }
    return out.str();
}
