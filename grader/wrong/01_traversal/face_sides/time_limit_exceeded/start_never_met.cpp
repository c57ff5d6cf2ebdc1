// Remembers the opposite half-edge as the start: the walk never meets it.
// Hint: You wait for a start that your walk never meets.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = he[i].opp;
    int sides = 0;
    do {
        sides++;
        i = he[i].next;
    } while (i != start);
    return sides;
}
