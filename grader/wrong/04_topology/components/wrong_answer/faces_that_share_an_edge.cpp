// Searches from face to face, across edges with a face on both sides: loose
// edges join nothing, nor do common vertices.
// Hint: You go from face to face; parts of a mesh also hang together by a
// vertex or a loose edge.
#include "exercises/04_topology/components.h"

#include <map>
#include <set>
#include <vector>

int components(const HalfEdgeTable& he) {
    std::map<int, std::vector<int>> neighbours;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1) neighbours[he[i].fi].push_back(he[he[i].opp].fi);
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
                if (g != -1 && seen.insert(g).second) todo.push_back(g);
        }
    }
    return found;
}
