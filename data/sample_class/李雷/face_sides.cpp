#include "exercises/01_traversal/face_sides.h"

// 面的边数
int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int n = 0, j = i;
    do { n++; j = he[j].next; } while (j != i);
    return n;
}
