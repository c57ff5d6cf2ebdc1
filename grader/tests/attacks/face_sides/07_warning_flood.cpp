// accepted all: THREATS 7, warnings without an end, below the limit of errors
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

#define W1 { int he = 1; { int he = 2; } }
#define W2 W1 W1 W1 W1 W1 W1 W1 W1 W1 W1
#define W3 W2 W2 W2 W2 W2 W2 W2 W2 W2 W2
void f() { W3 W3 }
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
