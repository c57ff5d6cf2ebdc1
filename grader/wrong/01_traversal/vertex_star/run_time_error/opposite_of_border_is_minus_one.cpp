// Believes that a half-edge without a face has no opposite one: he[-1].
// Hint: You believe that a half-edge without a face has no opposite one.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        int across = he[i].fi == -1 ? -1 : he[i].opp;
        star.push_back(he[across].vi);
        i = he[across].next;
    } while (i != start);
    return star;
}
