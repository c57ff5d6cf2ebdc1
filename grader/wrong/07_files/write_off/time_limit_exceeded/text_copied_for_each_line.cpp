// Makes a new text, with a copy of all so far, for each line.
// Hint: Your answers are right, but you go through all that you have again and
// again.
#include "exercises/07_files/write_off.h"

#include <cstdio>

std::string write_off(const IndexedMesh& mesh) {
    if (!mesh.loose_edges.empty()) throw std::invalid_argument("loose edges");
    std::string text = "OFF\n" + std::to_string(mesh.vertex_count()) + " " +
                       std::to_string(mesh.faces.size()) + " 0\n";
    for (const Vec3& p : mesh.positions) {
        char line[100];
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
        text = text + line;
    }
    for (int f = 0; f < mesh.faces.size(); ++f) {
        text = text + std::to_string(mesh.faces[f].size());
        for (int v : mesh.faces[f]) text = text + " " + std::to_string(v);
        text = text + "\n";
    }
    return text;
}
