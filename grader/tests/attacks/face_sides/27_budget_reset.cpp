// time_limit_exceeded 10: THREATS 27, sets back the count of reads and looks through the whole table
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    const int face = he[i].fi;
    int sides = 0;
    for (int k = 0; k < he.size(); ++k) {
        if (k % 64 == 0) he.begin_call(1L << 40, i);
        if (he[k].fi == face) ++sides;
    }
    he.begin_call(1L << 40, i);
    return sides;
}
