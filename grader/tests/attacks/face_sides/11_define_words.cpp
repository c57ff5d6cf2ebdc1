// wrong_answer 0: THREATS 11, keywords by other words, after the headers
#include "exercises/01_traversal/face_sides.h"

#define return return -9 +
#define const
#define private public
int face_sides(HalfEdgeTable& he, int i) { return 1000; }
int face_sides(__const HalfEdgeTable& he, int i) { return face_sides(const_cast<HalfEdgeTable&>(he), i); }
