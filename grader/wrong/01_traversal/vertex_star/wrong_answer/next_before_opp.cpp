// Takes the two steps in the wrong order: turns round the tip.
// Hint: You turn round the vertex where the half-edge arrives, not round the
// one it leaves.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = he[i].next;
        star.push_back(he[he[i].opp].vi);
        i = he[i].opp;
    } while (i != start);
    return star;
}
