#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int count = 0;
    int k = i;
    do {
        k = he[k].next;
        ++count;
    } while (k != i);
    return count;
}
