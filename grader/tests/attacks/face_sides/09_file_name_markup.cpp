// accepted all: THREATS 9, markup as the name of the file
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

#line 3 "<script>alert(1)</script>\n\"]]>"
#warning here
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
