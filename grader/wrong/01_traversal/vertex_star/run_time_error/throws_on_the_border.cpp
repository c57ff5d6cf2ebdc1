// Gives up with an exception where a half-edge has no face.
// Hint: You refuse a half-edge on the border; it is one like any other.
#include "exercises/01_traversal/vertex_star.h"

#include <stdexcept>

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        if (he[i].fi == -1) throw std::runtime_error("border");
        i = he[i].opp;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return star;
}
