// Declares a second i inside the loop: the first one never moves.
// Hint: You wait for a start that your walk never meets.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = he[i].next;
    int sides = 0;
    do {
        sides++;
        int i = he[start].next;
        if (he[i].fi == -1) return 0;
    } while (i != start);
    return sides;
}
