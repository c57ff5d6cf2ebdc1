#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    // on traverse toujours : i est du côté de la face
    i = he[i].opp;
    if (he[i].fi != -1) return {};
    std::vector<int> tour;
    int start = i;
    do {
        tour.push_back(i);
        i = he[i].next;
    } while (i != start);
    return tour;
}
