// Drops the first of equal faces as well.
// Hint: You drop all of several equal faces, the first one as well.
#include "exercises/09_processing/clean_mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

IndexedMesh clean_mesh(const IndexedMesh& mesh) {
    auto at = [](int i) { return static_cast<std::size_t>(i); };

    std::vector<std::vector<int>> faces;
    std::set<std::vector<int>> seen;
    for (FaceList::Face face : mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        corners.erase(std::unique(corners.begin(), corners.end()),
                      corners.end());
        if (corners.size() > 1 && corners.back() == corners.front())
            corners.pop_back();
        std::set<int> distinct(corners.begin(), corners.end());
        if (corners.size() < 3 || distinct.size() < corners.size()) continue;
        std::vector<int> key = corners;
        std::rotate(key.begin(), std::min_element(key.begin(), key.end()),
                    key.end());
        faces.push_back(corners);
    }

    std::map<std::vector<int>, int> often;
    auto key_of = [](std::vector<int> key) {
        std::rotate(key.begin(), std::min_element(key.begin(), key.end()),
                    key.end());
        return key;
    };
    for (const auto& corners : faces) ++often[key_of(corners)];
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [&](const auto& corners) {
                                   return often[key_of(corners)] > 1;
                               }),
                faces.end());

    std::vector<int> number(mesh.positions.size(), -1);
    for (const std::vector<int>& corners : faces)
        for (int v : corners) number[at(v)] = 0;
    IndexedMesh clean;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == -1) continue;
        number[v] = clean.vertex_count();
        clean.positions.push_back(mesh.positions[v]);
    }
    for (std::vector<int>& corners : faces) {
        for (int& v : corners) v = number[at(v)];
        clean.faces.push_back(corners);
    }
    return clean;
}
