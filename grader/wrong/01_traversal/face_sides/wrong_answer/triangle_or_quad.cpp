// Looks three steps ahead and knows triangles and quads only.
// Hint: You know triangles and quads only; faces may have more sides.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int third = he[he[he[i].next].next].next;
    return third == i ? 3 : 4;
}
