// Goes to the face by its number: he[-1] as soon as there is none.
// Hint: You use the number of a face as that of a half-edge.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    int across = he[he[i].opp].fi;
    if (he[across].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
