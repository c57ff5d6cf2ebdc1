// Compares all faces at a vertex with each other: quadratic where many meet.
// Hint: Your answers are right, but you take too long where many faces meet at
// one vertex.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

bool is_manifold(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces;
    std::map<int, std::vector<std::array<int, 2>>> at;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0, n = face.size(); k < n; ++k) {
            int a = face[k], b = face[(k + 1) % n];
            if (++faces[{std::min(a, b), std::max(a, b)}] > 2) return false;
            at[a].push_back({face[(k + n - 1) % n], b});
        }
    for (auto& [v, left] : at) {
        std::vector<std::array<int, 2>> reached = {left.back()};
        left.pop_back();
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (std::size_t j = left.size(); j-- > 0;) {
                auto [a, b] = left[j];
                auto [c, d] = reached[k];
                if (a != c && a != d && b != c && b != d) continue;
                reached.push_back(left[j]);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
            }
        if (!left.empty()) return false;
    }
    return true;
}
