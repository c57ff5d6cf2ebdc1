#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;   // Rand
    int start = i;
    int n = 0;
    do {
        int i = he[start].next;     // ein Schritt weiter
        n = n + 1;
        i = he[i].next;
    } while (he[i].next != start);
    return n;
}
