// A static cursor goes on where the last call, on another mesh, has ended.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    static int j = i;
    for (int steps = 0; steps < 8 && he[j].next != i; ++steps) j = he[j].next;
    return j;
}
