#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    int start = i;
    int cotes = 0;
    do {
        cotes++;
        i = he[i].next;
    } while (i != start);
    return cotes;
}
