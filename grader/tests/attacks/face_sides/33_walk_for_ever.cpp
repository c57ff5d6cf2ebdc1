// time_limit_exceeded 0: THREATS 33, a walk on a table that it made endless
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    HalfEdgeTable mine = he;
    mine.begin_call(1L << 62);
    while (true) i = mine[i].next;
}
