// wrong_answer 0: THREATS 29, the least and the greatest int
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) { return i % 2 == 0 ? -2147483647 - 1 : 2147483647 - he[i].fi * 0; }
