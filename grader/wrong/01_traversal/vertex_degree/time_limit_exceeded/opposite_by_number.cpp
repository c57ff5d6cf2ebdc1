// Takes i ^ 1 for the opposite half-edge: in a large table the walk goes far
// astray.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[i ^ 1].next;
    } while (i != start);
    return degree;
}
