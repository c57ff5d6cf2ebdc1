// Numbers the vertices from 0 to the largest: a number that is not in use is
// taken for a component.
// Hint: You take a vertex number that nothing uses for a component.
#include "exercises/04_topology/components.h"

#include <algorithm>
#include <vector>

int components(const HalfEdgeTable& he) {
    int n = 0;
    for (int i = 0; i < he.size(); ++i) n = std::max(n, he[i].vi + 1);
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(n));
    for (int i = 0; i < he.size(); ++i)
        neighbours[static_cast<std::size_t>(he[i].vi)].push_back(
            he[he[i].opp].vi);
    int found = 0;
    std::vector<bool> seen(static_cast<std::size_t>(n));
    for (int start = 0; start < n; ++start) {
        if (seen[static_cast<std::size_t>(start)]) continue;
        ++found;
        std::vector<int> todo = {start};
        while (!todo.empty()) {
            auto v = static_cast<std::size_t>(todo.back());
            todo.pop_back();
            if (seen[v]) continue;
            seen[v] = true;
            for (int w : neighbours[v]) todo.push_back(w);
        }
    }
    return found;
}
