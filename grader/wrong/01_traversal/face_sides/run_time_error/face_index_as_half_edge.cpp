// Uses the face index as the index of a half-edge: he[-1] on the border.
// Hint: You use the number of a face as that of a half-edge.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    int row = he[fi].fi;
    if (fi == -1 || row < -1) return 0;
    int start = i;
    int sides = 0;
    do {
        sides++;
        i = he[i].next;
    } while (i != start);
    return sides;
}
