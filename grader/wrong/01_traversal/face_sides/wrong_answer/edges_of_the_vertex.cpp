// Turns round the vertex: opp and next in place of next.
// Hint: You turn round a vertex where the face was asked for.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int sides = 0;
    do {
        sides++;
        i = he[he[i].opp].next;
    } while (i != start);
    return sides;
}
