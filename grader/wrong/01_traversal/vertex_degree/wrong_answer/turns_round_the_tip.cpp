// Takes next before opp: turns round the vertex at the tip.
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
