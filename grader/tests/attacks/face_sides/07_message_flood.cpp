// accepted all: THREATS 7, pragmas that print
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

#define P _Pragma("message \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\"")
#define P2 P P P P P P P P P P
#define P3 P2 P2 P2 P2 P2 P2 P2 P2 P2 P2
P3 P3 P3
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
