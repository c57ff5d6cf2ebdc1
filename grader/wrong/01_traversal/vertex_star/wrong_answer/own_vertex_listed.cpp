// Notes vi before it crosses the edge: the vertex itself, again and again.
// Hint: You list the vertex itself.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        star.push_back(he[i].vi);
        i = he[he[i].opp].next;
    } while (i != start);
    return star;
}
