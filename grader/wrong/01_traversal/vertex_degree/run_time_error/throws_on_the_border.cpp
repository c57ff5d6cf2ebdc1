// Gives up with an exception where a half-edge has no face.
// Hint: You refuse a half-edge on the border; it is one like any other.
#include "exercises/01_traversal/vertex_degree.h"

#include <stdexcept>

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        if (he[i].fi == -1) throw std::logic_error("no face here");
        degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
