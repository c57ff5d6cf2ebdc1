// Leaves the edges out that have no face on one side.
// Hint: You leave out edges that have no face on one side.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        if (he[i].fi != -1) star.push_back(he[he[i].opp].vi);
        i = he[he[i].opp].next;
    } while (i != start);
    return star;
}
