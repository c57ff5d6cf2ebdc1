// Stops when it is at the first vertex again; a face may pass it twice.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int first = he[i].vi;
    int sides = 0;
    do {
        sides++;
        i = he[i].next;
    } while (he[i].vi != first);
    return sides;
}
