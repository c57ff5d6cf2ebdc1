#include "grader/suites/09_processing/smoothing_oracle.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "course/runner/suite.h"

namespace course::oracle {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// How many sides of faces lie along each edge; loose edges have none.
std::map<std::pair<int, int>, int> sides_of_edges(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> sides;
    for (const FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            ++sides[std::minmax({face[k], face[(k + 1) % face.size()]})];
    for (const auto& [a, b] : mesh.loose_edges) sides[std::minmax({a, b})];
    return sides;
}

}  // namespace

std::vector<bool> free_to_move(const IndexedMesh& mesh) {
    std::vector<bool> has_edge(mesh.positions.size(), false);
    std::vector<bool> lacks_face(mesh.positions.size(), false);
    for (const auto& [edge, sides] : sides_of_edges(mesh))
        for (const int v : {edge.first, edge.second}) {
            has_edge[at(v)] = true;
            if (sides < 2) lacks_face[at(v)] = true;
        }
    for (std::size_t v = 0; v < has_edge.size(); ++v)
        has_edge[v] = has_edge[v] && !lacks_face[v];
    return has_edge;
}

std::vector<Vec3> smoothed(const IndexedMesh& mesh, int steps, double w) {
    std::vector<std::vector<int>> neighbours(mesh.positions.size());
    for (const auto& [edge, sides] : sides_of_edges(mesh)) {
        neighbours[at(edge.first)].push_back(edge.second);
        neighbours[at(edge.second)].push_back(edge.first);
    }
    const std::vector<bool> moves = free_to_move(mesh);
    std::vector<Vec3> now = mesh.positions;
    for (int step = 0; step < steps; ++step) {
        const std::vector<Vec3> before = now;
        for (std::size_t v = 0; v < now.size(); ++v) {
            if (!moves[v]) continue;
            const double share = w / static_cast<double>(neighbours[v].size());
            for (const int n : neighbours[v])
                now[v] = now[v] + share * (before[at(n)] - before[v]);
        }
    }
    return now;
}

}  // namespace course::oracle

namespace course::hidden {

IndexedMesh roughened(IndexedMesh mesh, std::uint64_t salt) {
    std::mt19937_64 random(seed() * 1000 + salt);
    const auto up_to_one = [&] {
        return static_cast<double>(random() % 2001) / 1000 - 1;
    };
    for (Vec3& p : mesh.positions)
        for (double* x : {&p.x, &p.y, &p.z}) *x += 0.3 * up_to_one();
    return mesh;
}

}  // namespace course::hidden
