// Stops at the gap: the edges behind it are missing.
// Hint: You stop where there is no face; the walk goes on behind the gap.
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
