// Answers -1 where the contract says 0.
// Hint: Look again at what the contract says of a half-edge that has no face.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return fi;
    int start = i;
    int sides = 0;
    do {
        sides++;
        i = he[i].next;
    } while (i != start);
    return sides;
}
