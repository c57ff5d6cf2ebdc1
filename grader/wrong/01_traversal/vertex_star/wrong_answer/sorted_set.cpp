// Collects in a set: sorted, not in the order of the walk.
// Hint: Your answers are the right ones, but not in the order of the walk.
#include "exercises/01_traversal/vertex_star.h"

#include <set>

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    std::set<int> star;
    int start = i;
    do {
        i = he[i].opp;
        star.insert(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return {star.begin(), star.end()};
}
