// Takes the face for a half-edge of the face: on the border that is he[-1].
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = he[i].fi;
    for (int steps = 0; steps < 20 && he[j].next != i; ++steps) j = he[j].next;
    return j;
}
