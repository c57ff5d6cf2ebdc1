#include "grader/suites/09_processing/face_lists.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "course/runner/suite.h"

namespace course::hidden {

namespace {

/// 0 .. n - 1 in any order, the same on every platform.
std::vector<int> mixed(int n, std::mt19937_64& random) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[random() % k]);
    return order;
}

}  // namespace

std::vector<std::vector<int>> faces_from_smallest(const FaceList& faces) {
    std::vector<std::vector<int>> all;
    for (const FaceList::Face face : faces) {
        std::vector<int> corners(face.begin(), face.end());
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
        all.push_back(std::move(corners));
    }
    return all;
}

IndexedMesh shuffled(const IndexedMesh& mesh, std::uint64_t salt) {
    std::mt19937_64 random(seed() * 1000 + salt);
    const std::vector<int> vertex = mixed(mesh.vertex_count(), random);
    IndexedMesh result = mesh;
    for (std::size_t v = 0; v < vertex.size(); ++v)
        result.positions[static_cast<std::size_t>(vertex[v])] =
            mesh.positions[v];
    result.faces = {};
    for (const int f : mixed(mesh.faces.size(), random)) {
        std::vector<int> corners;
        for (const int v : mesh.faces[f])
            corners.push_back(vertex[static_cast<std::size_t>(v)]);
        if (!corners.empty())
            std::rotate(corners.begin(),
                        corners.begin() + static_cast<std::ptrdiff_t>(
                                              random() % corners.size()),
                        corners.end());
        result.faces.push_back(corners);
    }
    for (auto& edge : result.loose_edges)
        for (int& v : edge) v = vertex[static_cast<std::size_t>(v)];
    return result;
}

std::vector<Fixture> zoo_without_table() {
    return {zoo::moebius3q(), zoo::moebius5(),        zoo::klein4x4(),
            zoo::rp2_6(),     zoo::house_with_wall(), zoo::fan3()};
}

}  // namespace course::hidden
