// Makes a new text, with a copy of all so far, for each line.
// Hint: Your answers are right, but you go through all that you have again and
// again.
#include "exercises/07_files/write_obj.h"

#include <cstdio>

std::string write_obj(const IndexedMesh& mesh) {
    std::string text;
    for (const Vec3& p : mesh.positions) {
        char line[100];
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x, p.y,
                      p.z);
        text = text + line;
    }
    for (int f = 0; f < mesh.faces.size(); ++f) {
        text = text + "f";
        for (int v : mesh.faces[f]) text = text + " " + std::to_string(v + 1);
        text = text + "\n";
    }
    for (auto [a, b] : mesh.loose_edges)
        text = text + "l " + std::to_string(a + 1) + " " +
               std::to_string(b + 1) + "\n";
    return text;
}
