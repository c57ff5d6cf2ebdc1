// Counts the first side when it starts and again when it is back.
// Hint: You count the start twice: when you set out, and again when you are
// back.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 1;
    int start = i;
    do {
        sides++;
        i = he[i].next;
    } while (i != start);
    return sides;
}
