#include "exercises/09_processing/cluster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// The vertices of the mesh, gathered in cubes.
struct Clusters {
    std::vector<int> of_vertex;
    std::vector<Vec3> mean;
};

Clusters clusters(const std::vector<Vec3>& positions, double cell) {
    std::map<std::array<double, 3>, int> number;
    std::vector<int> count;
    Clusters result;
    for (Vec3 p : positions) {
        std::array<double, 3> cube = {std::floor(p.x / cell),
                                      std::floor(p.y / cell),
                                      std::floor(p.z / cell)};
        int next = static_cast<int>(number.size());
        int c = number.try_emplace(cube, next).first->second;
        if (c == next) {
            result.mean.push_back({});
            count.push_back(0);
        }
        result.of_vertex.push_back(c);
        result.mean[at(c)] = result.mean[at(c)] + p;
        ++count[at(c)];
    }
    for (std::size_t c = 0; c < count.size(); ++c)
        result.mean[c] = 1.0 / count[c] * result.mean[c];
    return result;
}

/// The face between clusters; neighbouring corners that are the same are one.
std::vector<int> clustered(FaceList::Face face, const Clusters& clusters) {
    std::vector<int> corners;
    for (int v : face) corners.push_back(clusters.of_vertex[at(v)]);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
    return corners;
}

bool is_degenerate(const std::vector<int>& corners) {
    std::set<int> distinct(corners.begin(), corners.end());
    return corners.size() < 3 || distinct.size() < corners.size();
}

/// The mesh without the vertices that no face uses.
IndexedMesh without_unused(const IndexedMesh& mesh) {
    std::vector<int> number(mesh.positions.size(), -1);
    for (int v : mesh.faces.corners()) number[at(v)] = 0;
    IndexedMesh result;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == -1) continue;
        number[v] = result.vertex_count();
        result.positions.push_back(mesh.positions[v]);
    }
    for (FaceList::Face face : mesh.faces) {
        std::vector<int> corners;
        for (int v : face) corners.push_back(number[at(v)]);
        result.faces.push_back(corners);
    }
    return result;
}

}  // namespace

IndexedMesh cluster(const IndexedMesh& mesh, double cell) {
    if (!(cell > 0) || std::isinf(cell))
        throw std::invalid_argument("cell: it is " + std::to_string(cell) +
                                    ", expected a finite number above 0");

    Clusters found = clusters(mesh.positions, cell);
    IndexedMesh coarse{found.mean, {}, {}};
    for (FaceList::Face face : mesh.faces) {
        std::vector<int> corners = clustered(face, found);
        if (!is_degenerate(corners)) coarse.faces.push_back(corners);
    }
    return without_unused(coarse);
}
