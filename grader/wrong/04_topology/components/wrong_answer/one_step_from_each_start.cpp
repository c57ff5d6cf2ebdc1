// Marks the neighbours of the start and searches no further.
// Hint: You do not follow the edges far enough: what several of them join
// comes out as several components.
#include "exercises/04_topology/components.h"

#include <map>
#include <set>
#include <vector>

int components(const HalfEdgeTable& he) {
    std::map<int, std::vector<int>> neighbours;
    for (int i = 0; i < he.size(); ++i)
        neighbours[he[i].vi].push_back(he[he[i].opp].vi);
    int found = 0;
    std::set<int> seen;
    for (const auto& [start, around] : neighbours) {
        if (seen.count(start) > 0) continue;
        ++found;
        seen.insert(start);
        std::vector<int> todo = {start};
        while (!todo.empty()) {
            int v = todo.back();
            todo.pop_back();
            for (int w : neighbours.at(v))
                seen.insert(w);
        }
    }
    return found;
}
