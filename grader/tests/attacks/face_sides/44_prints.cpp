// accepted or run_time_error <=11: THREATS 44, prints what breaks terminals and pages
#include "exercises/01_traversal/face_sides.h"
#include <cstdio>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

int face_sides(const HalfEdgeTable& he, int i) {
    fwrite("\xff\xfe\xc0\x80 \x1b[2J\x1b]0;title\x07 ]]> <script>alert(1)</script> &amp; \"' =cmd()\r\n\0 \u202e \v\f\b\x7f \xed\xa0\x80", 1, 60, stdout);
    return right(he, i);
}
