// accepted all: THREATS 11, private members made public
#include "exercises/01_traversal/face_sides.h"

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

#define private public
#define class struct
#include "course/halfedge/half_edge_table.h"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
