// Gives the vertex that the half-edge before leaves, not the half-edge.
// Hint: You give a vertex where a half-edge was asked for.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[j].next != i) j = he[j].next;
    return he[j].vi;
}
