#include "grader/suites/09_processing/clustering_oracle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace course::oracle {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

bool in_one_cube(Vec3 p, Vec3 q, double cell) {
    return std::floor(p.x / cell) == std::floor(q.x / cell) &&
           std::floor(p.y / cell) == std::floor(q.y / cell) &&
           std::floor(p.z / cell) == std::floor(q.z / cell);
}

/// For each vertex the first one in its cube.
std::vector<int> first_in_cube(const std::vector<Vec3>& positions,
                               double cell) {
    std::vector<int> first;
    for (const Vec3 p : positions) {
        int k = 0;
        while (!in_one_cube(p, positions[at(k)], cell)) ++k;
        first.push_back(k);
    }
    return first;
}

/// What is left of a face: a corner stays when the one before it differs.
std::vector<int> without_runs(const std::vector<int>& corners) {
    std::vector<int> kept;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (corners[k] != corners[(k + corners.size() - 1) % corners.size()])
            kept.push_back(corners[k]);
    return kept;
}

bool stays(const std::vector<int>& corners) {
    for (const int v : corners)
        if (std::count(corners.begin(), corners.end(), v) > 1) return false;
    return corners.size() >= 3;
}

Vec3 mean_in_cube(const std::vector<Vec3>& positions,
                  const std::vector<int>& first, int of) {
    Vec3 mean = positions[at(of)];  // running mean
    double n = 1;
    for (std::size_t v = at(of) + 1; v < positions.size(); ++v)
        if (first[v] == of) mean = mean + 1 / ++n * (positions[v] - mean);
    return mean;
}

}  // namespace

IndexedMesh clustered_mesh(const IndexedMesh& mesh, double cell) {
    const std::vector<int> first = first_in_cube(mesh.positions, cell);
    std::vector<std::vector<int>> faces;
    std::vector<bool> used(first.size(), false);
    for (const FaceList::Face face : mesh.faces) {
        std::vector<int> corners;
        for (const int v : face) corners.push_back(first[at(v)]);
        corners = without_runs(corners);
        if (!stays(corners)) continue;
        for (const int v : corners) used[at(v)] = true;
        faces.push_back(corners);
    }
    IndexedMesh result;
    std::vector<int> number(first.size(), -1);
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        number[v] = result.vertex_count();
        result.positions.push_back(
            mean_in_cube(mesh.positions, first, static_cast<int>(v)));
    }
    for (std::vector<int>& corners : faces) {
        for (int& v : corners) v = number[at(v)];
        result.faces.push_back(corners);
    }
    return result;
}

}  // namespace course::oracle
