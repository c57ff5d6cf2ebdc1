// Stops at the gap: the edges behind it are missing.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        degree++;
        if (he[i].fi == -1) break;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
