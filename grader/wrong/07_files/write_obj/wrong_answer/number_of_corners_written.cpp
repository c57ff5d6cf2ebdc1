// Writes how many corners a face has, as OFF wants it.
// Hint: You write the number of its corners into the line of a face.
#include "exercises/07_files/write_obj.h"

#include <limits>
#include <sstream>

std::string write_obj(const IndexedMesh& mesh) {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);

    for (Vec3 p : mesh.positions)
        out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (FaceList::Face face : mesh.faces) {
        out << "f " << face.size();
        for (int v : face) out << ' ' << v + 1;
        out << '\n';
    }
    for (auto [a, b] : mesh.loose_edges)
        out << "l " << a + 1 << ' ' << b + 1 << '\n';
    return out.str();
}
