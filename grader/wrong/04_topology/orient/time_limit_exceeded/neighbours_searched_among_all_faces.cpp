// Looks through all pairs of faces for those with a common edge.
// Hint: Your answers are right, but the larger the mesh is, the longer you
// search at every step.
#include "exercises/04_topology/orient.h"

#include <map>
#include <utility>

namespace {

/// 0: no common edge; 1: one that both run along alike; 2: against each other;
/// 3: both, or too many.
int common(FaceList::Face a, FaceList::Face b) {
    int kinds = 0;
    for (std::size_t j = 0; j < a.size(); ++j)
        for (std::size_t k = 0; k < b.size(); ++k) {
            int from = a[j], to = a[(j + 1) % a.size()];
            int start = b[k], tip = b[(k + 1) % b.size()];
            if (from == start && to == tip) kinds |= 1;
            if (from == tip && to == start) kinds |= 2;
        }
    return kinds;
}

}  // namespace

std::optional<std::vector<bool>> orient(const IndexedMesh& mesh) {
    auto n = static_cast<std::size_t>(mesh.faces.size());
    std::vector<std::optional<bool>> flags(n);
    for (std::size_t start = 0; start < n; ++start) {
        if (flags[start]) continue;
        flags[start] = false;
        std::vector<std::size_t> todo = {start};
        while (!todo.empty()) {
            std::size_t f = todo.back();
            todo.pop_back();
            for (std::size_t g = 0; g < n; ++g) {
                if (g == f) continue;
                int kinds = common(mesh.faces[static_cast<int>(f)],
                                   mesh.faces[static_cast<int>(g)]);
                if (kinds == 0) continue;
                bool wanted = *flags[f] != (kinds == 1);
                if (kinds == 3 || (flags[g] && *flags[g] != wanted))
                    return std::nullopt;
                if (!flags[g]) todo.push_back(g);
                flags[g] = wanted;
            }
        }
    }
    std::vector<bool> result;
    for (std::optional<bool> flag : flags) result.push_back(*flag);
    return result;
}
