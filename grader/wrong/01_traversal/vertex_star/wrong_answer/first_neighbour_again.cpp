// Closes the list with the first neighbour.
// Hint: You list the start at both ends.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = he[i].opp;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    star.push_back(star.front());
    return star;
}
