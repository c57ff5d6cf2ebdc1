// Answers 0 when i lies on the border.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
