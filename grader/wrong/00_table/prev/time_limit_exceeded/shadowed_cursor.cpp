// Declares a second cursor inside the loop, so the outer one never moves.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[j].next != i) {
        int j = he[i].next;
        j = he[j].next;
    }
    return j;
}
