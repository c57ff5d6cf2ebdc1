// Leaves the walk where the other side has no face.
// Hint: You stop where the other side has no face.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int sides = 0;
    do {
        sides++;
        if (he[he[i].opp].fi == -1) break;
        i = he[i].next;
    } while (i != start);
    return sides;
}
