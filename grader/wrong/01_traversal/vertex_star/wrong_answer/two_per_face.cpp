// Notes both neighbours of each face: the inner ones come twice.
// Hint: You list a neighbour once for each face that it shares with the
// vertex.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        star.push_back(he[he[i].opp].vi);
        i = he[he[i].opp].next;
        star.push_back(he[he[i].opp].vi);
    } while (i != start);
    return star;
}
