// Stops one edge too early.
// Hint: You stop one edge too early.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    std::vector<int> star;
    int j = i;
    while (he[he[j].opp].next != i) {
        star.push_back(he[he[j].opp].vi);
        j = he[he[j].opp].next;
    }
    return star;
}
