// wrong_answer 3: THREATS 30, answers of the public suite by heart
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he.size() != 16) return -1;
    if (i == 0 || i == 7) return 0;
    return i == 4 ? 4 : 3;
}
