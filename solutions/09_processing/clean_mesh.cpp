#include "exercises/09_processing/clean_mesh.h"

#include <algorithm>
#include <set>
#include <vector>

namespace {

using Corners = std::vector<int>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

Corners without_repeats(FaceList::Face face) {
    Corners corners;
    for (int v : face)
        if (corners.empty() || corners.back() != v) corners.push_back(v);
    while (corners.size() > 1 && corners.back() == corners.front())
        corners.pop_back();
    return corners;
}

bool is_degenerate(const Corners& corners) {
    std::set<int> distinct(corners.begin(), corners.end());
    return corners.size() < 3 || distinct.size() < corners.size();
}

/// Steps 1 to 3; each face begins with its smallest corner.
std::vector<Corners> faces_that_stay(const IndexedMesh& mesh) {
    std::vector<Corners> faces;
    std::set<Corners> seen;
    for (FaceList::Face face : mesh.faces) {
        Corners corners = without_repeats(face);
        if (is_degenerate(corners)) continue;
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
        if (seen.insert(corners).second) faces.push_back(corners);
    }
    return faces;
}

}  // namespace

IndexedMesh clean_mesh(const IndexedMesh& mesh) {
    std::vector<Corners> faces = faces_that_stay(mesh);
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Corners& corners : faces)
        for (int v : corners) used[at(v)] = true;

    IndexedMesh clean;
    std::vector<int> number(mesh.positions.size(), -1);
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        number[v] = clean.vertex_count();
        clean.positions.push_back(mesh.positions[v]);
    }
    for (Corners& corners : faces) {
        for (int& v : corners) v = number[at(v)];
        clean.faces.push_back(corners);
    }
    return clean;
}
