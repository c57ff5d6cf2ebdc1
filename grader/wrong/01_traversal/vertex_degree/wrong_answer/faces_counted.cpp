// Counts the faces: one too few at the border.
// Hint: You count faces, not edges.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        if (he[i].fi != -1) degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
