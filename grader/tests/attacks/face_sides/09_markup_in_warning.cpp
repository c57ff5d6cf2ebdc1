// accepted all: THREATS 9, markup and control bytes in a warning
#include "exercises/01_traversal/face_sides.h"

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

#warning <script>alert(1)</script> ]]> & \x1b[31m =cmd()
#pragma message "\x1b[2J\x1b[1;1H <b>accepted</b> \r\n\x07 ]]> <!--"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
