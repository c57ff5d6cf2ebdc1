// Stops where there is no face: what lies behind the gap is missing.
// Hint: You stop where there is no face; the walk goes on behind the gap.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = he[i].opp;
        star.push_back(he[i].vi);
        if (he[i].fi == -1) break;
        i = he[i].next;
    } while (i != start);
    return star;
}
