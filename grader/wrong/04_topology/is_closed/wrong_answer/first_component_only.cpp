// Searches from row 0 on by next and opp, and does not go on in other components.
// Hint: You do not leave the component that you begin in.
#include "exercises/04_topology/is_closed.h"

#include <vector>

bool is_closed(const HalfEdgeTable& he) {
    if (he.empty()) return true;
    std::vector<bool> seen(static_cast<std::size_t>(he.size()));
    std::vector<int> todo = {0};
    while (!todo.empty()) {
        int i = todo.back();
        todo.pop_back();
        if (seen[static_cast<std::size_t>(i)]) continue;
        seen[static_cast<std::size_t>(i)] = true;
        if (he[i].fi == -1) return false;
        todo.push_back(he[i].next);
        todo.push_back(he[i].opp);
    }
    return true;
}
