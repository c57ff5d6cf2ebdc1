// Takes next before opp: turns round the vertex at the tip.
// Hint: You turn round the vertex where the half-edge arrives, not round the
// one it leaves.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[he[i].next].opp;
    } while (i != start);
    return degree;
}
