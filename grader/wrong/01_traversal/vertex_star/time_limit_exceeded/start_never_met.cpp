// Tests for the end between opp and next, where the start is never met.
// Hint: You wait for a start that your walk never meets.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    while (true) {
        i = he[i].opp;
        if (i == start) break;
        star.push_back(he[i].vi);
        i = he[i].next;
    }
    return star;
}
