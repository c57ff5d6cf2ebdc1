// Counts the first edge when it starts and again when it is back.
// Hint: You count the start twice: when you set out, and again when you are
// back.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 1;
    do {
        degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
