// Takes i ^ 1 for the opposite half-edge.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        if (he[i ^ 1].fi != -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
