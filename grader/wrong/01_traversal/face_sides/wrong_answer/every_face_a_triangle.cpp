// Takes every face for a triangle.
// Hint: You take every face for a triangle.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    return 3;
}
