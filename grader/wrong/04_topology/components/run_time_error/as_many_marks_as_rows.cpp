// Keeps the neighbours in a vector as long as the table.
// Hint: You use the number of a vertex as an index; it may be larger
// than the table.
#include "exercises/04_topology/components.h"

#include <vector>

int components(const HalfEdgeTable& he) {
    auto n = static_cast<std::size_t>(he.size());
    std::vector<std::vector<int>> neighbours(n);
    for (int i = 0; i < he.size(); ++i)
        neighbours.at(static_cast<std::size_t>(he[i].vi))
            .push_back(he[he[i].opp].vi);
    int found = 0;
    std::vector<bool> seen(n);
    for (std::size_t start = 0; start < n; ++start) {
        if (seen[start] || neighbours[start].empty()) continue;
        ++found;
        std::vector<std::size_t> todo = {start};
        while (!todo.empty()) {
            std::size_t v = todo.back();
            todo.pop_back();
            if (seen.at(v)) continue;
            seen[v] = true;
            for (int w : neighbours[v])
                todo.push_back(static_cast<std::size_t>(w));
        }
    }
    return found;
}
