// Walks rightly, but first looks for the smallest half-edge in the table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    for (int k = he.size() - 1; k >= 0; k--)
        if (he[k].vi == he[i].vi && k == i) start = k;
    std::vector<int> star;
    i = start;
    do {
        i = he[i].opp;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return star;
}
