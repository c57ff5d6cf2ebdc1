// Reads number after number, and does not know on which line they stand.
// Hint: You read number after number, whatever lines they stand on.
#include "exercises/07_files/read_off.h"

#include <sstream>

IndexedMesh read_off(const std::string& text) {
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        all += line.substr(0, line.find('#')) + "\n";
    std::istringstream in(all);
    std::string off;
    int nv = 0, nf = 0, ne = 0;
    in >> off >> nv >> nf >> ne;
    if (!in || off != "OFF") throw std::runtime_error("line 1: header");
    IndexedMesh mesh;
    for (int v = 0; v < nv; ++v) {
        Vec3 p;
        if (!(in >> p.x >> p.y >> p.z))
            throw std::runtime_error("line " + std::to_string(3 + v) + ": bad");
        mesh.positions.push_back(p);
    }
    for (int f = 0; f < nf; ++f) {
        int n = 0;
        in >> n;
        std::vector<int> face;
        for (int k = 0, v = 0; k < n && in >> v; ++k) face.push_back(v);
        if (!in || n < 3)
            throw std::runtime_error("line " + std::to_string(3 + nv + f) +
                                     ": bad");
        for (int v : face)
            if (v < 0 || v >= nv)
                throw std::runtime_error("line " + std::to_string(3 + nv + f) +
                                         ": no such vertex");
        mesh.faces.push_back(face);
        std::string colour;
        std::getline(in, colour);
    }
    return mesh;
}
