// Takes i ^ 1 for the opposite half-edge: in a large table the walk goes far
// astray.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = i ^ 1;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return star;
}
