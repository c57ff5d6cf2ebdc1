// Goes by next and opp: never passes a vertex where two fans are not linked.
// Hint: You do not get from one fan to the other at a vertex where two
// of them meet.
#include "exercises/04_topology/components.h"

#include <vector>

int components(const HalfEdgeTable& he) {
    std::vector<bool> seen(static_cast<std::size_t>(he.size()));
    int found = 0;
    for (int start = 0; start < he.size(); ++start) {
        if (seen[static_cast<std::size_t>(start)]) continue;
        ++found;
        std::vector<int> todo = {start};
        while (!todo.empty()) {
            int i = todo.back();
            todo.pop_back();
            if (seen[static_cast<std::size_t>(i)]) continue;
            seen[static_cast<std::size_t>(i)] = true;
            todo.push_back(he[i].next);
            todo.push_back(he[i].opp);
        }
    }
    return found;
}
