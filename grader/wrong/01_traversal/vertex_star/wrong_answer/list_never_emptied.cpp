// The list is static: each call adds to the one before.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    static std::vector<int> star;
    int start = i;
    do {
        i = he[i].opp;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return star;
}
