// Searches from face to face and takes the border, -1, for a face: all open
// parts hang together there.
// Hint: You take the border for a face: open parts hang together there.
#include "exercises/04_topology/components.h"

#include <map>
#include <set>
#include <vector>

int components(const HalfEdgeTable& he) {
    std::map<int, std::vector<int>> neighbours;
    for (int i = 0; i < he.size(); ++i)
        neighbours[he[i].fi].push_back(he[he[i].opp].fi);
    int found = 0;
    std::set<int> seen;
    for (const auto& [start, around] : neighbours) {
        if (!seen.insert(start).second) continue;
        ++found;
        std::vector<int> todo = {start};
        while (!todo.empty()) {
            int f = todo.back();
            todo.pop_back();
            for (int g : neighbours.at(f))
                if (seen.insert(g).second) todo.push_back(g);
        }
    }
    return found;
}
