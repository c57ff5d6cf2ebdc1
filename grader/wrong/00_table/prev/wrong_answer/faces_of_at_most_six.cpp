// Gives up after six steps: faces and borders may be longer.
// Hint: You give up after a few steps; faces and borders may be longer.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    for (int steps = 0; steps < 6 && he[j].next != i; ++steps) j = he[j].next;
    return j;
}
